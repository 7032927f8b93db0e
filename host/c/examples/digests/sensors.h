/* The sensors of the golden scenes, as their TOML files have them, for C99 and C++17. Each triad has, in this order: constant,
 * turn_on, gauss_markov, correlation_s, white, random_walk, instability, scale_factor, misalignment, g_sensitivity, saturation,
 * quantization, and what these sensors have none of: matrices, temperature, bandwidth, latency. */

#ifndef SENSORS_H
#define SENSORS_H

#include "schuler.h"

#define DEGREE (3.14159265358979323846 / 180.0)
#define ARCSECOND (DEGREE / 3600.0)
#define PER_HOUR (DEGREE / 3600.0)
#define MICRO_G 9.80665e-6
#define GRAVITY 9.80665
#define NONE { 0.0, 0.0, 0.0 }
#define REST { NONE, NONE, NONE }, { NONE, NONE, NONE }, NONE, NONE, NONE, NONE, NONE
#define ALL(x) { (x), (x), (x) }

static const schuler_triad_f64 paper_gyros = {
    ALL(0.1 * PER_HOUR), NONE, ALL(0.1 * PER_HOUR), ALL(720.0), ALL(0.01 * (DEGREE / 60.0)), NONE, NONE, NONE, NONE, NONE, NONE,
    NONE, REST,
};

static const schuler_triad_f64 paper_accelerometers = {
    NONE, NONE, ALL(100.0 * MICRO_G), ALL(720.0), NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, REST,
};

static const schuler_triad_f64 turns_gyros = {
    { 0.3 * PER_HOUR, -0.2 * PER_HOUR, 0.1 * PER_HOUR },
    ALL(0.5 * PER_HOUR),
    { 0.4 * PER_HOUR, 0.2 * PER_HOUR, 0.1 * PER_HOUR },
    { 5.0, 60.0, 720.0 },
    ALL(0.05 * (DEGREE / 60.0)),
    ALL(2.0 * (PER_HOUR / 60.0)),
    ALL(0.2 * PER_HOUR),
    { 50.0 * 1e-6, -30.0 * 1e-6, 20.0 * 1e-6 },
    { 20.0 * ARCSECOND, -10.0 * ARCSECOND, 15.0 * ARCSECOND },
    ALL(0.1 * (PER_HOUR / GRAVITY)),
    { 280.0 * DEGREE, 60.0 * DEGREE, 60.0 * DEGREE },
    ALL(0.2 * ARCSECOND),
    REST,
};

static const schuler_triad_f64 turns_accelerometers = {
    { 50.0 * MICRO_G, -40.0 * MICRO_G, 30.0 * MICRO_G },
    ALL(60.0 * MICRO_G),
    { 80.0 * MICRO_G, 40.0 * MICRO_G, 20.0 * MICRO_G },
    { 5.0, 60.0, 720.0 },
    ALL(0.02 * (1.0 / 60.0)),
    ALL(100.0 * (MICRO_G / 60.0)),
    ALL(25.0 * MICRO_G),
    { -60.0 * 1e-6, 40.0 * 1e-6, 20.0 * 1e-6 },
    { -12.0 * ARCSECOND, 18.0 * ARCSECOND, 9.0 * ARCSECOND },
    NONE,
    { 9.0 * GRAVITY, 9.0 * GRAVITY, 5.0 * GRAVITY },
    ALL(1e-4),
    REST,
};

#endif
