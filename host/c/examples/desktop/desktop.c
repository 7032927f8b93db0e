/* A unit in a vehicle at rest, emulated: found level and north, then navigated in single precision, corrected and stored. */

#include "schuler.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEGREE (3.14159265358979323846 / 180.0)

static void must(int32_t status)
{
    if (status != SCHULER_OK) {
        (void)fprintf(stderr, "desktop: %s: %s\n", schuler_result_name(status), schuler_result_text(status));
        exit(1);
    }
}

int main(void)
{
    const double rate_hz = 100.0, latitude = 45.0 * DEGREE, yaw = 30.0 * DEGREE;
    const double level = 7.292115e-5 * cos(latitude) / rate_hz, up = 7.292115e-5 * sin(latitude) / rate_hz;
    const schuler_increment_f64 perfect = {
        { level * cos(yaw), -level * sin(yaw), -up },
        { 0.0, 0.0, -9.806199203 / rate_hz },
    };
    /* A ring-laser unit: 0.001 deg/sqrt(h), 10 ug. */
    const schuler_triad_f64 gyros = { .white = { 2.9e-7, 2.9e-7, 2.9e-7 } };
    const schuler_triad_f64 accelerometers = { .constant = { 1e-4, 1e-4, 1e-4 } };
    schuler_emulator_f64 unit;
    schuler_alignment_f64 alignment;
    schuler_still_f64 still;
    schuler_vector_f64 angles, at_rest = { 0.0, 0.0, 0.0 };
    schuler_solution_f64 initial, solution;
    schuler_f32_local_level_h0b4a0 navigator;
    schuler_carried carried;
    schuler_correction_f32 correction = { { 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F } };
    uint8_t stored[SCHULER_F32_LOCAL_LEVEL_H0B4A0_SAVED];
    double north, east;
    int i;

    must(schuler_emulator_f64_start(&unit, SCHULER_ABI, 1.0 / rate_hz, 90000U, &gyros, &accelerometers, 1U, 0U));
    must(schuler_alignment_f64_start(&alignment, SCHULER_ABI, 1.0));
    for (i = 0; i < 30000; i++) {
        schuler_increment_f64 sample;
        must(schuler_emulator_f64_read(&unit, &perfect, &sample));
        must(schuler_alignment_f64_add(&alignment, &sample, 1.0 / rate_hz));
    }
    must(schuler_alignment_f64_attitude(&alignment, &angles));
    must(schuler_alignment_f64_judge(&alignment, latitude, 0.1, 0.0, &still));
    (void)printf("roll %.4f, pitch %.4f, heading %.3f deg, heading to %.3f deg; contradiction %ld\n",
                 angles.x / DEGREE, angles.y / DEGREE, angles.z / DEGREE, still.heading_sigma_rad / DEGREE,
                 (long)still.contradiction);

    must(schuler_solution_f64_from(latitude, 0.1, 0.0, &at_rest, &angles, &initial));
    must(schuler_f32_local_level_h0b4a0_start(&navigator, SCHULER_ABI, rate_hz, 0U, &initial));
    must(schuler_carried_start(&carried, SCHULER_ABI));
    for (i = 0; i < 6000; i++) {
        schuler_increment_f64 sample;
        schuler_increment_f32 narrow;
        must(schuler_emulator_f64_read(&unit, &perfect, &sample));
        must(schuler_carried_narrow(&carried, &sample, &narrow));
        must(schuler_f32_local_level_h0b4a0_push(&navigator, &narrow));
        if (i == 2999) {
            must(schuler_f32_local_level_h0b4a0_save(&navigator, stored, sizeof stored));
            must(schuler_f32_local_level_h0b4a0_forget(&navigator));
            must(schuler_f32_local_level_h0b4a0_restore(&navigator, SCHULER_ABI, stored, sizeof stored));
        }
    }
    must(schuler_f32_local_level_h0b4a0_read(&navigator, &solution));
    north = (solution.position[0].value - latitude) * 6.37e6;
    east = (solution.position[1].value - 0.1) * 6.37e6 * cos(latitude);
    (void)printf("after a minute %.3f m north, %.3f m east, %.3f m up\n", north, east, solution.position[2].value);

    /* A fix says that the vehicle has not moved. */
    correction.position_ned[0] = (float)-north;
    correction.position_ned[1] = (float)-east;
    correction.position_ned[2] = (float)solution.position[2].value;
    must(schuler_f32_local_level_h0b4a0_correct(&navigator, &correction));
    must(schuler_f32_local_level_h0b4a0_read(&navigator, &solution));
    (void)printf("corrected: %.3f m up\n", solution.position[2].value);
    return ((fabs(angles.z - yaw) < 1.0 * DEGREE) && (fabs(solution.position[2].value) < 1e-3)
            && (fabs(north) < 10.0)) ? 0 : 1;
}
