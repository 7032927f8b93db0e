/* Holds the functions of a port against tests/golden/functions: every word has to be the same.
 *
 *     functions gravity.txt radii.txt textbook.txt */

#include "mechanization.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST 32

/* What the function of a file makes of a row's first words. */
static size_t compute(const char *name, const double *in, double *out)
{
    if (strcmp(name, "gravity f64") == 0) {
        out[2] = gravity(in[0], in[1]);
        return 3;
    }
    if (strcmp(name, "radii f64") == 0) {
        radii r = radii_at(in[0]);
        out[2] = r.meridian;
        out[3] = r.prime_vertical;
        return 4;
    }
    if (strcmp(name, "textbook f64") == 0) {
        increment now = { { in[0], in[1], in[2] }, { in[3], in[4], in[5] } };
        increment before = { { in[6], in[7], in[8] }, { in[9], in[10], in[11] } };
        motion m = compensated(&now, &before);
        const double words[7] = { m.rotation.w, m.rotation.v.x, m.rotation.v.y, m.rotation.v.z,
                                  m.velocity.x, m.velocity.y, m.velocity.z };
        (void)memcpy(&out[12], words, sizeof words);
        return 19;
    }
    return 0;
}

int main(int argc, char **argv)
{
    static char line[2048];
    unsigned wrong = 0, rows = 0;
    int i;

    for (i = 1; i < argc; i++) {
        FILE *file = fopen(argv[i], "r");

        if (file == NULL) {
            perror(argv[i]);
            return 2;
        }
        while (fgets(line, sizeof line, file) != NULL) {
            double words[MOST], mine[MOST];
            size_t count = 0, all, k;
            char name[32] = "";
            char *at = line, *end;

            if (sscanf(line, "%15[a-z] %3[0-9f]", name, &name[16]) != 2) {
                continue;
            }
            (void)strcat(strcat(name, " "), &name[16]);
            at = strchr(strchr(at, ' ') + 1, ' ');
            while (at != NULL && count < MOST) {
                uint64_t bits = strtoull(at, &end, 16);
                if (end == at) {
                    break;
                }
                (void)memcpy(&words[count], &bits, sizeof bits);
                count++;
                at = end;
            }
            (void)memcpy(mine, words, sizeof mine);
            all = compute(name, words, mine);
            if (all == 0U) {
                continue;
            }
            rows++;
            for (k = 0; k < all; k++) {
                if (all != count || memcmp(&words[k], &mine[k], sizeof mine[k]) != 0) {
                    (void)printf("%s: row %u, word %u: %.17g, not %.17g\n", argv[i], rows, (unsigned)k + 1U, mine[k], words[k]);
                    wrong++;
                    break;
                }
            }
        }
        (void)fclose(file);
    }
    (void)printf("%u rows, %u wrong\n", rows, wrong);
    return (rows > 0U && wrong == 0U) ? 0 : 1;
}
