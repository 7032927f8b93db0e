/* Flies the two scenes of the golden chains and says the digest of each stage: on every target the same, and those of
 * tests/golden. The program is the same on a desktop and on a microcontroller; `say` writes a text where it runs.
 *
 * flights.h holds the perfect increments and the initial solution of each scene as bits; tests/c.sh makes it of chains. */

#include "schuler.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "flights.h"

void say(const char *text);
int fly_all(void);

#define DEGREE (3.14159265358979323846 / 180.0)
#define PER_HOUR (DEGREE / 3600.0)
#define MICRO_G 9.80665e-6
#define ALL(x) { (x), (x), (x) }

/* The sensors of a scene, as its TOML file has them. */
static const schuler_triad_f64 paper_gyros = {
    .constant = ALL(0.1 * PER_HOUR),
    .gauss_markov = ALL(0.1 * PER_HOUR),
    .correlation_s = ALL(720.0),
    .white = ALL(0.01 * (DEGREE / 60.0)),
};

static const schuler_triad_f64 paper_accelerometers = {
    .gauss_markov = ALL(100.0 * MICRO_G),
    .correlation_s = ALL(720.0),
};

static const schuler_triad_f64 turns_gyros = {
    .constant = { 0.3 * PER_HOUR, -0.2 * PER_HOUR, 0.1 * PER_HOUR },
    .turn_on = ALL(0.5 * PER_HOUR),
    .gauss_markov = { 0.4 * PER_HOUR, 0.2 * PER_HOUR, 0.1 * PER_HOUR },
    .correlation_s = { 5.0, 60.0, 720.0 },
    .white = ALL(0.05 * (DEGREE / 60.0)),
    .random_walk = ALL(2.0 * (PER_HOUR / 60.0)),
    .instability = ALL(0.2 * PER_HOUR),
    .scale_factor = { 50.0 * 1e-6, -30.0 * 1e-6, 20.0 * 1e-6 },
    .misalignment = { 20.0 * (DEGREE / 3600.0), -10.0 * (DEGREE / 3600.0), 15.0 * (DEGREE / 3600.0) },
    .g_sensitivity = ALL(0.1 * (PER_HOUR / 9.80665)),
    .saturation = { 280.0 * DEGREE, 60.0 * DEGREE, 60.0 * DEGREE },
    .quantization = ALL(0.2 * (DEGREE / 3600.0)),
};

static const schuler_triad_f64 turns_accelerometers = {
    .constant = { 50.0 * MICRO_G, -40.0 * MICRO_G, 30.0 * MICRO_G },
    .turn_on = ALL(60.0 * MICRO_G),
    .gauss_markov = { 80.0 * MICRO_G, 40.0 * MICRO_G, 20.0 * MICRO_G },
    .correlation_s = { 5.0, 60.0, 720.0 },
    .white = ALL(0.02 * (1.0 / 60.0)),
    .random_walk = ALL(100.0 * (MICRO_G / 60.0)),
    .instability = ALL(25.0 * MICRO_G),
    .scale_factor = { -60.0 * 1e-6, 40.0 * 1e-6, 20.0 * 1e-6 },
    .misalignment = { -12.0 * (DEGREE / 3600.0), 18.0 * (DEGREE / 3600.0), 9.0 * (DEGREE / 3600.0) },
    .saturation = { 9.0 * 9.80665, 9.0 * 9.80665, 5.0 * 9.80665 },
    .quantization = ALL(1e-4),
};

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

#define STATES(name, words, sample) \
    static schuler_##name name;     \
    static schuler_digest digest_##name;
#define START(name, words, sample)                                              \
    status |= schuler_##name##_start(&name, SCHULER_ABI, of->rate_hz, 0U, &initial); \
    status |= schuler_digest_start(&digest_##name, SCHULER_ABI);
#define PUSH(name, words, sample)                  \
    status |= schuler_##name##_push(&name, &sample); \
    status |= schuler_##name##_digest(&name, &digest_##name);
#define SAY(name, words, sample) say_digest(of->name, words, &digest_##name);

static int fly(const scene *of)
{
    static schuler_emulator_f64 unit;
    static schuler_digest noise;
    static schuler_carried carried;
    NAVIGATORS(STATES)
    schuler_solution_f64 initial;
    int32_t status = SCHULER_OK;
    size_t i;

    (void)memcpy(&initial, of->initial, sizeof initial);
    status |= schuler_emulator_f64_start(&unit, SCHULER_ABI, 1.0 / of->rate_hz, of->samples, of->gyros,
                                         of->accelerometers, 1U, 0U);
    status |= schuler_digest_start(&noise, SCHULER_ABI);
    status |= schuler_carried_start(&carried, SCHULER_ABI);
    NAVIGATORS(START)
    for (i = 0; (i < of->samples) && (status == SCHULER_OK); i++) {
        schuler_increment_f64 twice;
        schuler_increment_f32 single;
        uint64_t words[6];

        (void)memcpy(&twice, of->increments[i], sizeof twice);
        status |= schuler_emulator_f64_read(&unit, &twice, &twice);
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
