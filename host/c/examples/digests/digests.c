/* Flies the two scenes of the golden chains and says the digest of each stage: on every target the same, and those of
 * tests/golden. The program is the same on a desktop and on a microcontroller; `say` writes a text where it runs.
 *
 * flights.h holds the perfect increments and the initial solution of each scene as bits; tests/c.sh makes it of chains. With
 * MEASURED they are what the sensors read: the emulator of every error term takes 5 KB, which a Cortex-M0 lacks. */

#include "schuler.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "flights.h"
#include "sensors.h"

void say(const char *text);
int fly_all(void);

/* A scene, and where its perfect increments are. */
typedef struct {
    const char *name;
    double rate_hz;
    size_t samples;
    const uint64_t *initial;
    const uint64_t (*increments)[6];
    const schuler_triad_f64 *gyros;
    const schuler_triad_f64 *accelerometers;
} scene;

static void say_digest(const char *name, const char *stage, const schuler_digest *digest)
{
    static const char digits[] = "0123456789abcdef";
    char text[18];
    uint64_t value = 0;
    size_t i;

    (void)schuler_digest_value(digest, &value);
    for (i = 0; i < 16; i++) {
        text[i] = digits[(value >> (60U - 4U * i)) & 15U];
    }
    text[16] = '\n';
    text[17] = '\0';
    say(name);
    say(" ");
    say(stage);
    say(" ");
    say(text);
}

/* The navigators: name, its words in a chain's file, and what its samples are. */
#define NAVIGATORS(X)                                                                   \
    X(f32_local_level_h0b4a0, "f32-local-level-taylor-0-4-0", single)                   \
    X(f32x2_local_level_h0b4a0, "f32x2-local-level-taylor-0-4-0", single)               \
    X(f64_local_level_h0b4a0, "f64-local-level-taylor-0-4-0", twice)                    \
    X(f64_earth_fixed_h0b4a0, "f64-earth-fixed-taylor-0-4-0", twice)                    \
    X(f32_local_level_textbook, "f32-local-level-textbook", single)                     \
    X(f64_local_level_textbook, "f64-local-level-textbook", twice)

#define STATES(id, words, sample) \
    static schuler_##id id;       \
    static schuler_digest digest_##id;
#define START(id, words, sample)                                                   \
    status |= schuler_##id##_start(&id, SCHULER_ABI, of->rate_hz, 0U, &initial);    \
    status |= schuler_digest_start(&digest_##id, SCHULER_ABI);
#define PUSH(id, words, sample)                \
    status |= schuler_##id##_push(&id, &sample); \
    status |= schuler_##id##_digest(&id, &digest_##id);
#define SAY(id, words, sample) say_digest(of->name, words, &digest_##id);

static int fly(const scene *of)
{
#ifndef MEASURED
    static schuler_emulator_f64 unit;
#endif
    static schuler_digest noise;
    static schuler_carried carried;
    NAVIGATORS(STATES)
    schuler_solution_f64 initial;
    int32_t status = SCHULER_OK;
    size_t i;

    (void)memcpy(&initial, of->initial, sizeof initial);
#ifndef MEASURED
    status |= schuler_emulator_f64_start(&unit, SCHULER_ABI, 1.0 / of->rate_hz, of->samples, of->gyros,
                                         of->accelerometers, 1U, 0U);
#endif
    status |= schuler_digest_start(&noise, SCHULER_ABI);
    status |= schuler_carried_start(&carried, SCHULER_ABI);
    NAVIGATORS(START)
    for (i = 0; (i < of->samples) && (status == SCHULER_OK); i++) {
        schuler_increment_f64 twice;
        schuler_increment_f32 single;
        uint64_t words[6];

        (void)memcpy(&twice, of->increments[i], sizeof twice);
#ifndef MEASURED
        status |= schuler_emulator_f64_read(&unit, &twice, &twice);
#endif
        (void)memcpy(words, &twice, sizeof words);
        status |= schuler_digest_add(&noise, words, 6U);
        status |= schuler_carried_narrow(&carried, &twice, &single);
        NAVIGATORS(PUSH)
    }
    if (status != SCHULER_OK) {
        say("refused\n");
        return 1;
    }
    say_digest(of->name, "noise", &noise);
    NAVIGATORS(SAY)
    return 0;
}

int fly_all(void)
{
    int failed = 0;
#ifdef PAPER_SAMPLES
    {
        const scene paper = { "paper", 20.0, PAPER_SAMPLES, paper_initial, paper_increments,
                              &paper_gyros, &paper_accelerometers };
        failed |= fly(&paper);
    }
#endif
#ifdef TURNS_SAMPLES
    {
        const scene turns = { "turns", 50.0, TURNS_SAMPLES, turns_initial, turns_increments,
                              &turns_gyros, &turns_accelerometers };
        failed |= fly(&turns);
    }
#endif
    return failed;
}
