/* What a program can get wrong: null and misaligned pointers, states that were never started, are another navigator's or
 * another version's, a header of another version, input that cannot be right, stored bytes that were damaged. Each has to
 * come back as its result, with the state as it was. Run under the sanitizers of addresses and of undefined behaviour. */

#include "schuler.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static unsigned checks = 0;
static unsigned failed = 0;

static void expect(int32_t got, int32_t wanted, const char *what, int line)
{
    checks++;
    if (got != wanted) {
        failed++;
        (void)printf("line %d: %s: %s, not %s\n", line, what, schuler_result_name(got), schuler_result_name(wanted));
    }
}

#define EXPECT(call, wanted) expect((call), (wanted), #call, __LINE__)

/* A call that has to fail and to leave a state as it was. */
#define REFUSED(state, call, wanted)                                        \
    do {                                                                    \
        (void)memcpy(before, &(state), sizeof(state));                      \
        EXPECT(call, wanted);                                               \
        expect(memcmp(before, &(state), sizeof(state)), 0, "changed by " #call, __LINE__); \
    } while (0)

static unsigned char before[65536];

/* Everything that one navigator must refuse; OTHER is the prefix of a navigator of another type. */
#define NAVIGATOR(NAME, NUMBER, OTHER)                                                                          \
static void NAME##_is_safe(const schuler_solution_f64 *level)                                                   \
{                                                                                                               \
    static schuler_##NAME state, unused, copy;                                                                  \
    static schuler_##OTHER other;                                                                               \
    schuler_##NAME *nothing = NULL;                                                                             \
    schuler_##NAME *foreign = (schuler_##NAME *)(void *)&other;                                                 \
    schuler_##NAME *crooked = (schuler_##NAME *)(void *)((unsigned char *)&copy + 1);                           \
    schuler_increment_##NUMBER sample = { { 0, 0, 0 }, { 0, 0, 0 } };                                           \
    schuler_increment_##NUMBER broken = { { 0, (NUMBER)NAN, 0 }, { 0, 0, 0 } };                                 \
    schuler_rates_##NUMBER rates = { { 0, 0, 0 }, { 0, 0, 0 } };                                                \
    schuler_correction_##NUMBER far = { { (NUMBER)1e6, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };                      \
    schuler_solution_f64 solution = *level, wrong = *level;                                                     \
    schuler_solution_##NUMBER own;                                                                              \
    schuler_digest digest, unstarted_digest;                                                                    \
    uint8_t *stored = malloc(schuler_##NAME##_stored), *torn = malloc(schuler_##NAME##_stored);                 \
    uint64_t samples = 7;                                                                                       \
    size_t i;                                                                                                   \
                                                                                                                \
    (void)memset(&own, 0, sizeof own);                                                                          \
    (void)memset(&unused, 0xa5, sizeof unused);                                                                 \
    (void)memset(&unstarted_digest, 0, sizeof unstarted_digest);                                                \
    expect(schuler_##NAME##_size() <= sizeof state, 1, "size of " #NAME, __LINE__);                             \
    EXPECT(schuler_digest_start(&digest, SCHULER_ABI), SCHULER_OK);                                             \
    EXPECT(schuler_##OTHER##_start(&other, SCHULER_ABI, 100.0, 0U, level), SCHULER_OK);                         \
                                                                                                                \
    /* Before the start. */                                                                                     \
    REFUSED(state, schuler_##NAME##_start(&state, SCHULER_ABI + 1U, 100.0, 0U, level), SCHULER_ERROR_ABI);      \
    REFUSED(state, schuler_##NAME##_start(&state, SCHULER_ABI, 100.0, 0U, NULL), SCHULER_ERROR_NULL);           \
    EXPECT(schuler_##NAME##_start(nothing, SCHULER_ABI, 100.0, 0U, level), SCHULER_ERROR_NULL);                 \
    EXPECT(schuler_##NAME##_start(crooked, SCHULER_ABI, 100.0, 0U, level), SCHULER_ERROR_MISALIGNED);           \
    REFUSED(state, schuler_##NAME##_start(&state, SCHULER_ABI, 0.0, 0U, level), SCHULER_ERROR_INTERVAL);        \
    REFUSED(state, schuler_##NAME##_start(&state, SCHULER_ABI, NAN, 0U, level), SCHULER_ERROR_INTERVAL);        \
    wrong.position[0].value = 2.0;                                                                              \
    REFUSED(state, schuler_##NAME##_start(&state, SCHULER_ABI, 100.0, 0U, &wrong), SCHULER_ERROR_POSITION);     \
    wrong = *level;                                                                                             \
    wrong.attitude[0].value = 0.5;                                                                              \
    REFUSED(state, schuler_##NAME##_start(&state, SCHULER_ABI, 100.0, 0U, &wrong), SCHULER_ERROR_ATTITUDE);     \
    REFUSED(state, schuler_##NAME##_push(&state, &sample), SCHULER_ERROR_NOT_STARTED);                          \
    REFUSED(unused, schuler_##NAME##_push(&unused, &sample), SCHULER_ERROR_NOT_STARTED);                        \
    REFUSED(unused, schuler_##NAME##_finish(&unused), SCHULER_ERROR_NOT_STARTED);                               \
    REFUSED(unused, schuler_##NAME##_correct(&unused, &far), SCHULER_ERROR_NOT_STARTED);                        \
    REFUSED(solution, schuler_##NAME##_read(&unused, &solution), SCHULER_ERROR_NOT_STARTED);                    \
    REFUSED(other, schuler_##NAME##_push(foreign, &sample), SCHULER_ERROR_FOREIGN);                             \
    REFUSED(other, schuler_##NAME##_hold_vertical(foreign, 0, 0), SCHULER_ERROR_FOREIGN);                       \
    REFUSED(other, schuler_##NAME##_finish(foreign), SCHULER_ERROR_FOREIGN);                                    \
    REFUSED(other, schuler_##NAME##_forget(foreign), SCHULER_ERROR_FOREIGN);                                    \
    REFUSED(samples, schuler_##NAME##_integrated(foreign, &samples), SCHULER_ERROR_FOREIGN);                    \
                                                                                                                \
    /* Under way. */                                                                                            \
    EXPECT(schuler_##NAME##_start(&state, SCHULER_ABI, 100.0, 0U, level), SCHULER_OK);                          \
    for (i = 0; i < 41U; i++) {                                                                                 \
        EXPECT(schuler_##NAME##_push(&state, &sample), SCHULER_OK);                                             \
    }                                                                                                           \
    REFUSED(state, schuler_##NAME##_start(&state, 0U, 100.0, 0U, level), SCHULER_ERROR_ABI);                    \
    REFUSED(state, schuler_##NAME##_start(&state, SCHULER_ABI, 1e-9, 0U, level), SCHULER_ERROR_INTERVAL);       \
    REFUSED(state, schuler_##NAME##_push(&state, NULL), SCHULER_ERROR_NULL);                                    \
    REFUSED(state, schuler_##NAME##_push(&state, &broken), SCHULER_REJECTED_ANGLE);                             \
    REFUSED(state, schuler_##NAME##_push_rates(&state, &rates, NULL), SCHULER_ERROR_NULL);                      \
    REFUSED(state, schuler_##NAME##_correct(&state, &far), SCHULER_CORRECTION_SIZE);                            \
    REFUSED(state, schuler_##NAME##_correct(&state, NULL), SCHULER_ERROR_NULL);                                 \
    REFUSED(state, schuler_##NAME##_hold_vertical(&state, (NUMBER)INFINITY, 0), SCHULER_REJECTED_HELD);         \
    REFUSED(state, schuler_##NAME##_read(&state, NULL), SCHULER_ERROR_NULL);                                    \
    REFUSED(state, schuler_##NAME##_predict(&state, NULL), SCHULER_ERROR_NULL);                                 \
    REFUSED(state, schuler_##NAME##_read_own(&state, NULL), SCHULER_ERROR_NULL);                                \
    REFUSED(state, schuler_##NAME##_digest(&state, NULL), SCHULER_ERROR_NULL);                                  \
    REFUSED(state, schuler_##NAME##_digest(&state, &unstarted_digest), SCHULER_ERROR_NOT_STARTED);              \
    REFUSED(digest, schuler_##NAME##_digest(&unused, &digest), SCHULER_ERROR_NOT_STARTED);                      \
    REFUSED(state, schuler_##NAME##_read(&state, &solution), SCHULER_OK);                                       \
    REFUSED(state, schuler_##NAME##_predict(&state, &solution), SCHULER_OK);                                    \
    REFUSED(state, schuler_##NAME##_predict_own(&state, &own), SCHULER_OK);                                     \
                                                                                                                \
    /* Stored and restored; every byte that is wrong, and every byte that lacks, is noticed. */                 \
    REFUSED(state, schuler_##NAME##_save(&state, stored, schuler_##NAME##_stored - 1U), SCHULER_ERROR_SPACE);   \
    REFUSED(state, schuler_##NAME##_save(&state, NULL, schuler_##NAME##_stored), SCHULER_ERROR_NULL);           \
    REFUSED(state, schuler_##NAME##_save(&state, stored, schuler_##NAME##_stored), SCHULER_OK);                 \
    for (i = 0; i < schuler_##NAME##_stored; i++) {                                                             \
        (void)memcpy(torn, stored, schuler_##NAME##_stored);                                                    \
        torn[i] ^= 0x10U;                                                                                       \
        (void)memcpy(before, &state, sizeof state);                                                             \
        expect(schuler_##NAME##_restore(&state, SCHULER_ABI, torn, schuler_##NAME##_stored) < 0, 1, "torn", __LINE__); \
        expect(schuler_##NAME##_restore(&state, SCHULER_ABI, stored, i) < 0, 1, "short", __LINE__);             \
        expect(memcmp(before, &state, sizeof state), 0, "changed by torn bytes", __LINE__);                     \
    }                                                                                                           \
    REFUSED(state, schuler_##NAME##_restore(&state, SCHULER_ABI + 1U, stored, schuler_##NAME##_stored), SCHULER_ERROR_ABI); \
    REFUSED(state, schuler_##NAME##_restore(&state, SCHULER_ABI, NULL, 8U), SCHULER_ERROR_NULL);                \
    REFUSED(other, schuler_##OTHER##_restore(&other, SCHULER_ABI, stored, schuler_##NAME##_stored), SCHULER_ERROR_FOREIGN); \
    EXPECT(schuler_##NAME##_restore(&copy, SCHULER_ABI, stored, schuler_##NAME##_stored), SCHULER_OK);          \
    for (i = 0; i < 23U; i++) {                                                                                 \
        EXPECT(schuler_##NAME##_push(&state, &sample), SCHULER_OK);                                             \
        EXPECT(schuler_##NAME##_push(&copy, &sample), SCHULER_OK);                                              \
    }                                                                                                           \
    EXPECT(schuler_##NAME##_save(&state, stored, schuler_##NAME##_stored), SCHULER_OK);                         \
    EXPECT(schuler_##NAME##_save(&copy, torn, schuler_##NAME##_stored), SCHULER_OK);                            \
    expect(memcmp(stored, torn, schuler_##NAME##_stored), 0, "restored otherwise", __LINE__);                   \
                                                                                                                \
    /* A state of another version of the library; then one that is done with. */                               \
    copy.opaque[0] ^= 2U;                                                                                       \
    REFUSED(copy, schuler_##NAME##_push(&copy, &sample), SCHULER_ERROR_STALE);                                  \
    REFUSED(copy, schuler_##NAME##_forget(&copy), SCHULER_ERROR_STALE);                                         \
    EXPECT(schuler_##NAME##_forget(&state), SCHULER_OK);                                                        \
    REFUSED(state, schuler_##NAME##_push(&state, &sample), SCHULER_ERROR_NOT_STARTED);                          \
    free(stored);                                                                                               \
    free(torn);                                                                                                 \
}

typedef float f32;
typedef double f64;

#define schuler_f32_local_level_h0b4a0_stored SCHULER_F32_LOCAL_LEVEL_H0B4A0_SAVED
#define schuler_f32x2_earth_fixed_h2b4a2_stored SCHULER_F32X2_EARTH_FIXED_H2B4A2_SAVED
#define schuler_f64_earth_fixed_h2b4a2_any_stored SCHULER_F64_EARTH_FIXED_H2B4A2_ANY_SAVED
#define schuler_f64_local_level_textbook_stored SCHULER_F64_LOCAL_LEVEL_TEXTBOOK_SAVED

NAVIGATOR(f32_local_level_h0b4a0, f32, f32_local_level_h0b4a0_any)
NAVIGATOR(f32x2_earth_fixed_h2b4a2, f32, f32_earth_fixed_h2b4a2)
NAVIGATOR(f64_earth_fixed_h2b4a2_any, f64, f64_earth_fixed_h2b4a2)
NAVIGATOR(f64_local_level_textbook, f64, f64_earth_fixed_textbook)

static void what_goes_beside_is_safe(void)
{
    static schuler_carried carried;
    static schuler_digest digest;
    static schuler_alignment_f32 alignment;
    static schuler_emulator_f64 unit;
    static schuler_decoder decoder;
    static schuler_target target;
    schuler_increment_f64 wide = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
    schuler_increment_f32 narrow = { { 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F } };
    schuler_vector_f32 angles = { 1.0F, 2.0F, 3.0F };
    schuler_triad_f64 none, bad;
    schuler_frame frame;
    uint8_t line[SCHULER_MOST_ENCODED], payload[256];
    uint64_t value = 9;
    size_t written = 0, i;
    int32_t status = SCHULER_OK;

    (void)memset(&none, 0, sizeof none);
    (void)memset(&frame, 0, sizeof frame);
    (void)memset(payload, 3, sizeof payload);
    bad = none;
    bad.white[1] = -1.0;
    EXPECT(schuler_carried_start(&carried, 99U), SCHULER_ERROR_ABI);
    EXPECT(schuler_carried_narrow(&carried, &wide, &narrow), SCHULER_ERROR_NOT_STARTED);
    EXPECT(schuler_carried_start(&carried, SCHULER_ABI), SCHULER_OK);
    REFUSED(carried, schuler_carried_narrow(&carried, &wide, NULL), SCHULER_ERROR_NULL);
    EXPECT(schuler_carried_narrow((schuler_carried *)(void *)&unit, &wide, &narrow), SCHULER_ERROR_NOT_STARTED);
    EXPECT(schuler_digest_start(&digest, SCHULER_ABI), SCHULER_OK);
    REFUSED(digest, schuler_digest_add(&digest, NULL, 3U), SCHULER_ERROR_NULL);
    REFUSED(digest, schuler_digest_add((schuler_digest *)(void *)&carried, &value, 1U), SCHULER_ERROR_FOREIGN);
    EXPECT(schuler_alignment_f32_start(&alignment, SCHULER_ABI, -1.0F), SCHULER_ERROR_INTERVAL);
    EXPECT(schuler_alignment_f32_start(&alignment, SCHULER_ABI, 1.0F), SCHULER_OK);
    REFUSED(angles, schuler_alignment_f32_attitude(&alignment, &angles), SCHULER_ALIGNMENT_EMPTY);
    REFUSED(alignment, schuler_alignment_f32_add(&alignment, &narrow, NAN), SCHULER_REJECTED_INTERVAL);
    EXPECT(schuler_alignment_f32_add(&alignment, &narrow, 0.01F), SCHULER_OK);
    REFUSED(angles, schuler_alignment_f32_attitude(&alignment, &angles), SCHULER_ALIGNMENT_UNDETERMINED);
    REFUSED(unit, schuler_emulator_f64_start(&unit, SCHULER_ABI, 0.01, 100U, &bad, &none, 1U, 0U), SCHULER_PARAMETER_WHITE);
    REFUSED(unit, schuler_emulator_f64_start(&unit, SCHULER_ABI, 0.01, 0U, &none, &none, 1U, 0U), SCHULER_PARAMETER_SAMPLES);
    REFUSED(unit, schuler_emulator_f64_start(&unit, SCHULER_ABI, 0.0, 1U, &none, &none, 1U, 0U), SCHULER_PARAMETER_INTERVAL);
    REFUSED(unit, schuler_emulator_f64_start(&unit, SCHULER_ABI, 0.01, 1U, &none, NULL, 1U, 0U), SCHULER_ERROR_NULL);
    REFUSED(unit, schuler_emulator_f64_read(&unit, &wide, &wide), SCHULER_ERROR_NOT_STARTED);

    EXPECT(schuler_decoder_take(&decoder, 0U, &frame), SCHULER_ERROR_NOT_STARTED);
    EXPECT(schuler_decoder_start(&decoder, SCHULER_ABI), SCHULER_OK);
    REFUSED(decoder, schuler_decoder_take(&decoder, 7U, NULL), SCHULER_ERROR_NULL);
    EXPECT(schuler_encode(0x7fU, 1U, 2U, payload, 5U, line, sizeof line, &written), SCHULER_ERROR_KIND);
    EXPECT(schuler_encode(4U, 1U, 2U, payload, 238U, line, sizeof line, &written), SCHULER_ERROR_PAYLOAD);
    EXPECT(schuler_encode(4U, 1U, 2U, payload, 5U, line, 10U, &written), SCHULER_ERROR_SPACE);
    EXPECT(schuler_encode(4U, 1U, 2U, payload, 5U, line, sizeof line, &written), SCHULER_OK);
    for (i = 0; i < written; i++) {
        status = schuler_decoder_take(&decoder, line[i], &frame);
    }
    expect(status, SCHULER_FRAME, "a frame that was written is read", __LINE__);
    expect((frame.kind == 4U) && (frame.sequence == 1U) && (frame.time_ns == 2U) && (frame.length == 5U), 1, "its head", __LINE__);
    EXPECT(schuler_target_start(&target, SCHULER_ABI - 1U, 0U), SCHULER_ERROR_ABI);
    REFUSED(target, schuler_target_hello(&target, NULL, NULL), SCHULER_ERROR_NOT_STARTED);
    EXPECT(schuler_target_start(&target, SCHULER_ABI, 0U), SCHULER_OK);
    REFUSED(target, schuler_target_take(&target, 0U, NULL, NULL), SCHULER_ERROR_NULL);
}

int main(void)
{
    const schuler_vector_f64 none = { 0.0, 0.0, 0.0 };
    schuler_solution_f64 level;

    EXPECT(schuler_solution_f64_from(0.7, 0.1, 100.0, &none, &none, &level), SCHULER_OK);
    EXPECT(schuler_solution_f64_from(0.7, 0.1, 100.0, &none, NULL, &level), SCHULER_ERROR_NULL);
    f32_local_level_h0b4a0_is_safe(&level);
    f32x2_earth_fixed_h2b4a2_is_safe(&level);
    f64_earth_fixed_h2b4a2_any_is_safe(&level);
    f64_local_level_textbook_is_safe(&level);
    what_goes_beside_is_safe();
    (void)printf("%u checks, %u failed\n", checks, failed);
    return (failed == 0U) ? 0 : 1;
}
