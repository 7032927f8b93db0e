/* A port of the textbook's mechanization, written by hand in C99, without the library. It shows how a port is audited: it flies the samples of a golden flight and writes what it holds after every
 * sample as a chain, which `schuler audit compare` holds against the golden one.
 *
 *     textbook noise.chain f64-local-level-textbook.chain > mine.chain
 *     schuler audit compare f64-local-level-textbook.chain mine.chain
 *
 * Compiled with -DPLANTED it has a fault: the factors of the coning correction are exchanged, which turns its sign.
 * Compile it with -ffp-contract=off: a fused multiplication and addition rounds once where the others round twice.
 */

#include "mechanization.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The digest of a chain: four lanes, which the words of each state go into in turn. */
typedef struct {
    uint64_t lanes[4];
    uint64_t words;
} digest;

static uint64_t mix(uint64_t sum, uint64_t word)
{
    uint64_t x = (sum ^ word) * UINT64_C(0x9e3779b97f4a7c15);
    return x ^ (x >> 32);
}

static uint64_t value(const digest *d)
{
    uint64_t sum = mix(0, d->words);
    int i;

    for (i = 0; i < 4; i++) {
        sum = mix(sum, d->lanes[i]);
    }
    return sum;
}

/* A row of a stage, and its digest every 64 samples. */
static void row(digest *d, const char *stage, unsigned sample, const double *numbers, size_t count)
{
    size_t i;

    (void)printf("%s %u", stage, sample);
    for (i = 0; i < count; i++) {
        uint64_t bits;
        (void)memcpy(&bits, &numbers[i], sizeof bits);
        (void)printf(" %016" PRIx64, bits);
        d->lanes[i % 4U] = mix(d->lanes[i % 4U], bits);
        d->words++;
    }
    (void)printf("\n");
    if (sample % 64U == 0U) {
        (void)printf("%s # %u %016" PRIx64 "\n", stage, sample, value(d));
    }
}

/* The numbers after the first `skip` words of a line, of which each is 16 hexadecimal digits. */
static size_t numbers(const char *line, int skip, double *to, size_t most)
{
    size_t count = 0;

    while (skip > 0 && line != NULL) {
        line = strchr(line, ' ');
        line = (line == NULL) ? NULL : line + 1;
        skip--;
    }
    while (line != NULL && count < most) {
        char *end;
        uint64_t bits = strtoull(line, &end, 16);
        if (end - line != 16) {
            break;
        }
        (void)memcpy(&to[count], &bits, sizeof bits);
        count++;
        line = (*end == ' ') ? end + 1 : NULL;
    }
    return count;
}

static const char *const fields =
    "stage: body f64 rotation rotation rotation rotation velocity velocity velocity\n"
    "stage: nav f64 position position position sine cosine velocity velocity velocity "
    "attitude attitude attitude attitude velocity_change velocity_change velocity_change latitude_change altitude_change\n";

int main(int argc, char **argv)
{
    static char line[4096];
    FILE *samples = (argc == 3) ? fopen(argv[1], "r") : NULL;
    FILE *golden = (argc == 3) ? fopen(argv[2], "r") : NULL;
    increment before = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
    digest of_body = { { 1, 2, 3, 4 }, 0 }, of_nav = { { 1, 2, 3, 4 }, 0 };
    double initial[20], six[6], rate_hz = 0.0;
    unsigned sample = 0;
    state at;

    if (samples == NULL || golden == NULL) {
        (void)fprintf(stderr, "textbook NOISE.chain GOLDEN.chain: two chains of one flight\n");
        return 2;
    }
    (void)printf("schuler chain 1\n");
    (void)memset(&at, 0, sizeof at);
    while (fgets(line, sizeof line, golden) != NULL && line[0] != '\n') {
        if (strncmp(line, "initial: ", 9) == 0 && numbers(line, 1, initial, 20) == 20U) {
            /* Pairs of a number and its rest, which this navigator does not use. */
            at.latitude = initial[0];
            at.longitude = initial[2];
            at.altitude = initial[4];
            at.velocity = of(initial[6], initial[8], initial[10]);
            at.attitude.w = initial[12];
            at.attitude.v = of(initial[14], initial[16], initial[18]);
        } else if (strncmp(line, "rate_hz: ", 9) == 0) {
            rate_hz = strtod(line + 9, NULL);
        }
        if (strncmp(line, "scene: ", 7) == 0 || strncmp(line, "rate_hz: ", 9) == 0 || strncmp(line, "seed: ", 6) == 0) {
            (void)fputs(line, stdout);
        }
    }
    at.sine = sin(at.latitude);
    at.cosine = cos(at.latitude);
    (void)printf("configuration: f64 local-level textbook\nport: C, by hand\n%s\n", fields);
    while (fgets(line, sizeof line, samples) != NULL) {
        if (strncmp(line, "noise ", 6) == 0 && numbers(line, 2, six, 6) == 6U) {
            increment now;
            motion body;

            now.angle = of(six[0], six[1], six[2]);
            now.velocity = of(six[3], six[4], six[5]);
            body = compensated(&now, &before);
            step(&at, &body, 1.0 / rate_hz);
            before = now;
            sample++;
            {
                const double of_motion[7] = { body.rotation.w, body.rotation.v.x, body.rotation.v.y, body.rotation.v.z,
                                              body.velocity.x, body.velocity.y, body.velocity.z };
                const double of_state[17] = { at.latitude, at.longitude, at.altitude, at.sine, at.cosine,
                                              at.velocity.x, at.velocity.y, at.velocity.z,
                                              at.attitude.w, at.attitude.v.x, at.attitude.v.y, at.attitude.v.z,
                                              at.velocity_change.x, at.velocity_change.y, at.velocity_change.z,
                                              at.latitude_change, at.altitude_change };
                row(&of_body, "body", sample, of_motion, 7);
                row(&of_nav, "nav", sample, of_state, 17);
            }
        }
    }
    (void)printf("body = %u %016" PRIx64 "\nnav = %u %016" PRIx64 "\n", sample, value(&of_body), sample, value(&of_nav));
    (void)fclose(samples);
    (void)fclose(golden);
    return (sample > 0U) ? 0 : 1;
}
