/* Schuler: strapdown inertial navigation, for C99 and C++17. host/c/README.md has how to build the library.
 *
 * Units are radians, metres, seconds, rad/s, m/s and m/s^2. Body axes are forward, right, down, local axes north, east, down. A
 * sample's time is the end of its interval.
 *
 * A state is the caller's memory, on the stack or static, and the library's content: start it, then pass it by pointer. Nothing
 * is allocated, nothing is kept elsewhere, so each thread may have states of its own; a state is used by one thread at a time. What
 * comes back is SCHULER_OK or a negative result, after which every state and every output is as it was. A pointer is either null,
 * which is a result, or leads to what its type says; where a length is given, to so many of it.
 *
 * This file is written by host/c/tests/header.rs from the sources. */

#ifndef SCHULER_H
#define SCHULER_H

#include <stddef.h>
#include <stdint.h>

/** The version of this interface: what a program was compiled with has to be what it is linked with. */
#define SCHULER_ABI 1

/** Readings at rest contradict nothing. */
#define SCHULER_STILL 0

/** Readings at rest are in another unit, or of another kind, than stated. */
#define SCHULER_STILL_UNITS 1

/** Specific force varies: the vehicle is not still. */
#define SCHULER_STILL_MOVING 2

/** Specific force is not gravity in any unit. */
#define SCHULER_STILL_FORCE 3

/** Specific force is not gravity, and steadier than a sensor with such an error: an acceleration. */
#define SCHULER_STILL_ACCELERATING 4

/** The body turns: gyros and the direction of specific force agree. */
#define SCHULER_STILL_TURNING 5

/** A rate that is too large for a bias and does not show in the accelerometers. */
#define SCHULER_STILL_RATE 6

/** Gyros and accelerometers contradict each other or the latitude: a sign, an axis, or the latitude is
 * wrong. */
#define SCHULER_STILL_DIRECTIONS 7

/** Bytes of a payload, at most. */
#define SCHULER_MOST_PAYLOAD 237

/** Bytes of a frame on the line, at most. */
#define SCHULER_MOST_ENCODED 257

/** Bytes that schuler_f64_local_level_h0b4a0_save writes. */
#define SCHULER_F64_LOCAL_LEVEL_H0B4A0_SAVED 768

/** Bytes that schuler_f64_local_level_h0b4a0_any_save writes. */
#define SCHULER_F64_LOCAL_LEVEL_H0B4A0_ANY_SAVED 840

/** Bytes that schuler_f64_local_level_h2b4a2_save writes. */
#define SCHULER_F64_LOCAL_LEVEL_H2B4A2_SAVED 1152

/** Bytes that schuler_f64_local_level_h2b4a2_any_save writes. */
#define SCHULER_F64_LOCAL_LEVEL_H2B4A2_ANY_SAVED 1288

/** Bytes that schuler_f64_local_level_textbook_save writes. */
#define SCHULER_F64_LOCAL_LEVEL_TEXTBOOK_SAVED 240

/** Bytes that schuler_f64_earth_fixed_h0b4a0_save writes. */
#define SCHULER_F64_EARTH_FIXED_H0B4A0_SAVED 776

/** Bytes that schuler_f64_earth_fixed_h0b4a0_any_save writes. */
#define SCHULER_F64_EARTH_FIXED_H0B4A0_ANY_SAVED 848

/** Bytes that schuler_f64_earth_fixed_h2b4a2_save writes. */
#define SCHULER_F64_EARTH_FIXED_H2B4A2_SAVED 1160

/** Bytes that schuler_f64_earth_fixed_h2b4a2_any_save writes. */
#define SCHULER_F64_EARTH_FIXED_H2B4A2_ANY_SAVED 1296

/** Bytes that schuler_f64_earth_fixed_textbook_save writes. */
#define SCHULER_F64_EARTH_FIXED_TEXTBOOK_SAVED 232

/** Bytes that schuler_f32_local_level_h0b4a0_save writes. */
#define SCHULER_F32_LOCAL_LEVEL_H0B4A0_SAVED 768

/** Bytes that schuler_f32_local_level_h0b4a0_any_save writes. */
#define SCHULER_F32_LOCAL_LEVEL_H0B4A0_ANY_SAVED 840

/** Bytes that schuler_f32_local_level_h2b4a2_save writes. */
#define SCHULER_F32_LOCAL_LEVEL_H2B4A2_SAVED 1152

/** Bytes that schuler_f32_local_level_h2b4a2_any_save writes. */
#define SCHULER_F32_LOCAL_LEVEL_H2B4A2_ANY_SAVED 1288

/** Bytes that schuler_f32_local_level_textbook_save writes. */
#define SCHULER_F32_LOCAL_LEVEL_TEXTBOOK_SAVED 240

/** Bytes that schuler_f32_earth_fixed_h0b4a0_save writes. */
#define SCHULER_F32_EARTH_FIXED_H0B4A0_SAVED 776

/** Bytes that schuler_f32_earth_fixed_h0b4a0_any_save writes. */
#define SCHULER_F32_EARTH_FIXED_H0B4A0_ANY_SAVED 848

/** Bytes that schuler_f32_earth_fixed_h2b4a2_save writes. */
#define SCHULER_F32_EARTH_FIXED_H2B4A2_SAVED 1160

/** Bytes that schuler_f32_earth_fixed_h2b4a2_any_save writes. */
#define SCHULER_F32_EARTH_FIXED_H2B4A2_ANY_SAVED 1296

/** Bytes that schuler_f32_earth_fixed_textbook_save writes. */
#define SCHULER_F32_EARTH_FIXED_TEXTBOOK_SAVED 232

/** Bytes that schuler_f32x2_local_level_h0b4a0_save writes. */
#define SCHULER_F32X2_LOCAL_LEVEL_H0B4A0_SAVED 768

/** Bytes that schuler_f32x2_local_level_h0b4a0_any_save writes. */
#define SCHULER_F32X2_LOCAL_LEVEL_H0B4A0_ANY_SAVED 840

/** Bytes that schuler_f32x2_local_level_h2b4a2_save writes. */
#define SCHULER_F32X2_LOCAL_LEVEL_H2B4A2_SAVED 1152

/** Bytes that schuler_f32x2_local_level_h2b4a2_any_save writes. */
#define SCHULER_F32X2_LOCAL_LEVEL_H2B4A2_ANY_SAVED 1288

/** Bytes that schuler_f32x2_earth_fixed_h0b4a0_save writes. */
#define SCHULER_F32X2_EARTH_FIXED_H0B4A0_SAVED 776

/** Bytes that schuler_f32x2_earth_fixed_h0b4a0_any_save writes. */
#define SCHULER_F32X2_EARTH_FIXED_H0B4A0_ANY_SAVED 848

/** Bytes that schuler_f32x2_earth_fixed_h2b4a2_save writes. */
#define SCHULER_F32X2_EARTH_FIXED_H2B4A2_SAVED 1160

/** Bytes that schuler_f32x2_earth_fixed_h2b4a2_any_save writes. */
#define SCHULER_F32X2_EARTH_FIXED_H2B4A2_ANY_SAVED 1296

/** done */
#define SCHULER_OK 0

/** a frame is complete */
#define SCHULER_FRAME 1

/** a pointer is null */
#define SCHULER_ERROR_NULL -1

/** a pointer is not aligned for what it leads to */
#define SCHULER_ERROR_MISALIGNED -2

/** the header is of another version than the library */
#define SCHULER_ERROR_ABI -3

/** the state has not been started */
#define SCHULER_ERROR_NOT_STARTED -4

/** the state is of another type */
#define SCHULER_ERROR_FOREIGN -5

/** the state is of another version of the library */
#define SCHULER_ERROR_STALE -6

/** the buffer is too small */
#define SCHULER_ERROR_SPACE -7

/** the stored state is none that navigation leaves: it was damaged on the way */
#define SCHULER_ERROR_DAMAGED -8

/** the sampling interval must be above 0 s and at most 1 s */
#define SCHULER_ERROR_INTERVAL -16

/** the limits must be positive and finite */
#define SCHULER_ERROR_LIMITS -17

/** the initial position must be finite: latitude within 90°, longitude within 360°, height within 1000
 * km */
#define SCHULER_ERROR_POSITION -18

/** the initial velocity must be finite and at most 100 km/s */
#define SCHULER_ERROR_VELOCITY -19

/** the initial attitude must be a unit quaternion to a thousandth */
#define SCHULER_ERROR_ATTITUDE -20

/** the local-level frame cannot start at a pole; earth-fixed can */
#define SCHULER_ERROR_POLE -21

/** the processor flushes subnormal numbers to zero; clear that mode */
#define SCHULER_ERROR_FLUSH_TO_ZERO -22

/** the angle increment is not finite or exceeds the limit */
#define SCHULER_REJECTED_ANGLE -32

/** the velocity increment is not finite or exceeds the limit */
#define SCHULER_REJECTED_VELOCITY -33

/** the local-level frame ends at the pole; earth-fixed goes on */
#define SCHULER_REJECTED_POLE -34

/** navigation has left the ellipsoid by over 1000 km: check signs and units of the samples, or hold the
 * vertical */
#define SCHULER_REJECTED_PLACE -35

/** the vertical to hold must be finite, within 1000 km and 100 km/s */
#define SCHULER_REJECTED_HELD -36

/** the sample's interval must be above 0 s and at most 1 s */
#define SCHULER_REJECTED_INTERVAL -37

/** the angle increment turns a block by over 2 rad: a window with a shorter block or a higher rate would
 * do */
#define SCHULER_REJECTED_TURN -38

/** the correction must be finite, within 10 km, 10 km/s and half a turn */
#define SCHULER_CORRECTION_SIZE -48

/** the correction is too large so near a pole; earth-fixed takes it */
#define SCHULER_CORRECTION_POLE -49

/** the correction leads over 1000 km from the ellipsoid */
#define SCHULER_CORRECTION_PLACE -50

/** the corrected state is none to go on from */
#define SCHULER_CORRECTION_STATE -51

/** there is no sample to align on */
#define SCHULER_ALIGNMENT_EMPTY -64

/** specific force and angular rate do not determine an attitude: one vanishes, or they are parallel */
#define SCHULER_ALIGNMENT_UNDETERMINED -65

/** sample interval: not positive, not finite or out of range */
#define SCHULER_PARAMETER_INTERVAL -80

/** number of samples: not positive */
#define SCHULER_PARAMETER_SAMPLES -81

/** constant bias: not finite or out of range */
#define SCHULER_PARAMETER_CONSTANT -82

/** rms of the turn-on bias: negative, not finite or out of range */
#define SCHULER_PARAMETER_TURN_ON -83

/** rms of the Gauss-Markov bias: negative, not finite or out of range */
#define SCHULER_PARAMETER_GAUSS_MARKOV -84

/** correlation time of the Gauss-Markov bias: not positive, not finite or out of range */
#define SCHULER_PARAMETER_CORRELATION -85

/** white noise: negative, not finite or out of range */
#define SCHULER_PARAMETER_WHITE -86

/** random walk of the bias: negative, not finite or out of range */
#define SCHULER_PARAMETER_RANDOM_WALK -87

/** bias instability: negative, not finite or out of range */
#define SCHULER_PARAMETER_INSTABILITY -88

/** scale factor error: not finite or out of range */
#define SCHULER_PARAMETER_SCALE_FACTOR -89

/** misalignment: not finite or out of range */
#define SCHULER_PARAMETER_MISALIGNMENT -90

/** g-sensitivity: not finite or out of range */
#define SCHULER_PARAMETER_G_SENSITIVITY -91

/** saturation: not positive, not finite or out of range */
#define SCHULER_PARAMETER_SATURATION -92

/** quantization: negative, not finite or out of range */
#define SCHULER_PARAMETER_QUANTIZATION -93

/** misalignment matrix: not finite or out of range */
#define SCHULER_PARAMETER_MISALIGNMENT_MATRIX -100

/** g-sensitivity matrix: not finite or out of range */
#define SCHULER_PARAMETER_G_SENSITIVITY_MATRIX -101

/** temperature and its rate: not finite */
#define SCHULER_PARAMETER_TEMPERATURE -102

/** how long the temperature changes: not positive or not finite */
#define SCHULER_PARAMETER_RAMP_TIME -103

/** bias by temperature: not finite or out of range */
#define SCHULER_PARAMETER_TEMPERATURE_BIAS -104

/** scale factor by temperature: not finite or out of range */
#define SCHULER_PARAMETER_TEMPERATURE_SCALE -105

/** bandwidth: not positive, not finite or out of range */
#define SCHULER_PARAMETER_BANDWIDTH -106

/** latency: negative, not finite or longer than 8 samples */
#define SCHULER_PARAMETER_LATENCY -107

/** the payload is longer than a frame holds */
#define SCHULER_ERROR_PAYLOAD -96

/** there is no such kind of frame */
#define SCHULER_ERROR_KIND -97

/** an error that this version of the header has no name for */
#define SCHULER_ERROR_OTHER -127

/** Samples at rest, gathered in f32. Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[38];
} schuler_alignment_f32;

/** A sample: the integrals of the rates over its interval, which it stands at the end of, in body axes
 * (forward, right, down). */
typedef struct {
    /** Angular rate against inertial space, integrated, rad. */
    float angle_b[3];
    /** Specific force (at rest gravity's magnitude upwards, hence negative z), integrated, m/s. */
    float velocity_b[3];
} schuler_increment_f32;

/** Three numbers. */
typedef struct {
    /** The first: x, north, or roll. */
    float x;
    /** The second: y, east, or pitch. */
    float y;
    /** The third: z, down, or yaw. */
    float z;
} schuler_vector_f32;

/** How good readings at rest are. */
typedef struct {
    /** Mean angular rate, rad/s. */
    float rate_ib_b[3];
    /** Mean specific force, m/s^2. */
    float specific_force_b[3];
    /** Standard deviation of roll and pitch, rad. */
    float level_sigma_rad;
    /** Standard deviation of the heading, rad; above 1 there is no heading. */
    float heading_sigma_rad;
    /** Specific force less gravity, m/s^2. */
    float force_off_m_s2;
    /** The smallest gyro error that explains the readings, rad/s. */
    float rate_off_rad_s;
    /** SCHULER_STILL, or what the readings contradict. */
    int32_t contradiction;
} schuler_still_f32;

/** Samples at rest, gathered in f64. Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[74];
} schuler_alignment_f64;

/** A sample: the integrals of the rates over its interval, which it stands at the end of, in body axes
 * (forward, right, down). */
typedef struct {
    /** Angular rate against inertial space, integrated, rad. */
    double angle_b[3];
    /** Specific force (at rest gravity's magnitude upwards, hence negative z), integrated, m/s. */
    double velocity_b[3];
} schuler_increment_f64;

/** Three numbers. */
typedef struct {
    /** The first: x, north, or roll. */
    double x;
    /** The second: y, east, or pitch. */
    double y;
    /** The third: z, down, or yaw. */
    double z;
} schuler_vector_f64;

/** How good readings at rest are. */
typedef struct {
    /** Mean angular rate, rad/s. */
    double rate_ib_b[3];
    /** Mean specific force, m/s^2. */
    double specific_force_b[3];
    /** Standard deviation of roll and pitch, rad. */
    double level_sigma_rad;
    /** Standard deviation of the heading, rad; above 1 there is no heading. */
    double heading_sigma_rad;
    /** Specific force less gravity, m/s^2. */
    double force_off_m_s2;
    /** The smallest gyro error that explains the readings, rad/s. */
    double rate_off_rad_s;
    /** SCHULER_STILL, or what the readings contradict. */
    int32_t contradiction;
} schuler_still_f64;

/** What the rounding of samples to single precision has dropped so far. Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[7];
} schuler_carried;

/** A number of type f64 as the sum of two: `value` is the number rounded, `rest` what rounding dropped, or
 * 0. */
typedef struct {
    /** The number, rounded. */
    double value;
    /** What rounding has dropped. */
    double rest;
} schuler_pair_f64;

/** A number of type f32 as the sum of two: `value` is the number rounded, `rest` what rounding dropped, or
 * 0. */
typedef struct {
    /** The number, rounded. */
    float value;
    /** What rounding has dropped. */
    float rest;
} schuler_pair_f32;

/** A running digest of states. Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[7];
} schuler_digest;

/** A unit of gyros and accelerometers, emulated in f32. Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[488];
} schuler_emulator_f32;

/** The errors of three gyros or three accelerometers, an axis each: x, y, z. A term whose numbers are all
 * 0 is absent: it draws no random numbers. "Angle" stands for rad of a gyro, m/s of an accelerometer. */
typedef struct {
    /** Constant bias, angle/s. */
    float constant[3];
    /** Rms of a bias that is drawn for each run, angle/s. */
    float turn_on[3];
    /** Rms of a first-order Gauss-Markov bias, angle/s. */
    float gauss_markov[3];
    /** Its correlation time, s; above 0 where there is one. */
    float correlation_s[3];
    /** White noise (angle or velocity random walk), angle/sqrt(s). */
    float white[3];
    /** Random walk of the bias, angle/s/sqrt(s). */
    float random_walk[3];
    /** Bias instability, angle/s. */
    float instability[3];
    /** Scale factor error, relative; positive reads too much. */
    float scale_factor[3];
    /** Rotation of the sensors' axes, rad. */
    float misalignment[3];
    /** Of gyros: rad/s per m/s^2. Of accelerometers 0. */
    float g_sensitivity[3];
    /** The largest output, angle/s. */
    float saturation[3];
    /** The least significant bit, angle. */
    float quantization[3];
    /** Misalignment of each axis by itself, rad: a row for each sensor, its parts along the body axes. An
     * element of the diagonal acts as a scale factor. */
    float misalignment_matrix[3][3];
    /** Of gyros: rad/s per m/s^2, a row for each gyro, its parts along the body axes. Of accelerometers 0. */
    float g_sensitivity_matrix[3][3];
    /** Temperature less that of calibration: at the start, K; how it changes, K/s; until when, s, which is
     * above 0 where one of the next two terms is there. */
    float temperature_ramp[3];
    /** Bias by temperature, angle/s/K. */
    float temperature_bias[3];
    /** Scale factor error by temperature, 1/K. */
    float temperature_scale[3];
    /** Bandwidth (-3 dB, first order), Hz; above 0 on every axis where there is one. */
    float bandwidth[3];
    /** Delay of the output, s; at most 8 samples. */
    float latency[3];
} schuler_triad_f32;

/** A unit of gyros and accelerometers, emulated in f64. Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[846];
} schuler_emulator_f64;

/** The errors of three gyros or three accelerometers, an axis each: x, y, z. A term whose numbers are all
 * 0 is absent: it draws no random numbers. "Angle" stands for rad of a gyro, m/s of an accelerometer. */
typedef struct {
    /** Constant bias, angle/s. */
    double constant[3];
    /** Rms of a bias that is drawn for each run, angle/s. */
    double turn_on[3];
    /** Rms of a first-order Gauss-Markov bias, angle/s. */
    double gauss_markov[3];
    /** Its correlation time, s; above 0 where there is one. */
    double correlation_s[3];
    /** White noise (angle or velocity random walk), angle/sqrt(s). */
    double white[3];
    /** Random walk of the bias, angle/s/sqrt(s). */
    double random_walk[3];
    /** Bias instability, angle/s. */
    double instability[3];
    /** Scale factor error, relative; positive reads too much. */
    double scale_factor[3];
    /** Rotation of the sensors' axes, rad. */
    double misalignment[3];
    /** Of gyros: rad/s per m/s^2. Of accelerometers 0. */
    double g_sensitivity[3];
    /** The largest output, angle/s. */
    double saturation[3];
    /** The least significant bit, angle. */
    double quantization[3];
    /** Misalignment of each axis by itself, rad: a row for each sensor, its parts along the body axes. An
     * element of the diagonal acts as a scale factor. */
    double misalignment_matrix[3][3];
    /** Of gyros: rad/s per m/s^2, a row for each gyro, its parts along the body axes. Of accelerometers 0. */
    double g_sensitivity_matrix[3][3];
    /** Temperature less that of calibration: at the start, K; how it changes, K/s; until when, s, which is
     * above 0 where one of the next two terms is there. */
    double temperature_ramp[3];
    /** Bias by temperature, angle/s/K. */
    double temperature_bias[3];
    /** Scale factor error by temperature, 1/K. */
    double temperature_scale[3];
    /** Bandwidth (-3 dB, first order), Hz; above 0 on every axis where there is one. */
    double bandwidth[3];
    /** Delay of the output, s; at most 8 samples. */
    double latency[3];
} schuler_triad_f64;

/** Collects bytes until a frame is complete. Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[37];
} schuler_decoder;

/** A frame that came through whole. */
typedef struct {
    /** End of the sample that it is about, ns from the start. */
    uint64_t time_ns;
    /** How many frames the sender has sent, this one included. */
    uint32_t sequence;
    /** What it is for: a code of the core's `link::kind`. */
    uint32_t kind;
    /** Bytes of the payload. */
    uint32_t length;
    /** The payload. */
    uint8_t payload[SCHULER_MOST_PAYLOAD];
} schuler_frame;

/** The navigator F64LocalLevel with the window H0B4A0 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[117];
} schuler_f64_local_level_h0b4a0;

/** Position, velocity and attitude. Where a navigator puts out its own axes, those of an Earth-fixed one
 * are Earth-fixed: position x, y, z in m, velocity x, y, z, attitude from body to Earth-fixed axes. */
typedef struct {
    /** Latitude (north positive) and longitude (east positive), rad; height above the ellipsoid, m. */
    schuler_pair_f64 position[3];
    /** North, east, down, relative to the Earth, m/s. */
    schuler_pair_f64 velocity[3];
    /** Unit quaternion w, x, y, z from body axes to north, east, down. */
    schuler_pair_f64 attitude[4];
} schuler_solution_f64;

/** Rates at an instant, in body axes (forward, right, down). */
typedef struct {
    /** Angular rate against inertial space, rad/s. */
    double rate_ib_b[3];
    /** Specific force, m/s^2. */
    double specific_force_b[3];
} schuler_rates_f64;

/** The corrected state less the present one, in north, east and down. Zeros change no bit. */
typedef struct {
    /** Position, m, at most 10 km. */
    double position_ned[3];
    /** Velocity, m/s, at most 10 km/s. */
    double velocity_ned[3];
    /** Attitude as the rotation vector from the present to the corrected one, rad, at most half a turn. */
    double attitude_ned[3];
} schuler_correction_f64;

/** The navigator F64LocalLevel with the window H0B4A0, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[126];
} schuler_f64_local_level_h0b4a0_any;

/** The navigator F64LocalLevel with the window H2B4A2 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[165];
} schuler_f64_local_level_h2b4a2;

/** The navigator F64LocalLevel with the window H2B4A2, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[182];
} schuler_f64_local_level_h2b4a2_any;

/** The textbook's algorithm, F64LocalLevelTextbook: a step for every sample, of any length, without delay.
 * Its state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[35];
} schuler_f64_local_level_textbook;

/** The navigator F64EarthFixed with the window H0B4A0 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[118];
} schuler_f64_earth_fixed_h0b4a0;

/** The navigator F64EarthFixed with the window H0B4A0, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[127];
} schuler_f64_earth_fixed_h0b4a0_any;

/** The navigator F64EarthFixed with the window H2B4A2 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[166];
} schuler_f64_earth_fixed_h2b4a2;

/** The navigator F64EarthFixed with the window H2B4A2, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[183];
} schuler_f64_earth_fixed_h2b4a2_any;

/** The textbook's algorithm, F64EarthFixedTextbook: a step for every sample, of any length, without delay.
 * Its state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[34];
} schuler_f64_earth_fixed_textbook;

/** The navigator F32LocalLevel with the window H0B4A0 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[62];
} schuler_f32_local_level_h0b4a0;

/** Position, velocity and attitude. Where a navigator puts out its own axes, those of an Earth-fixed one
 * are Earth-fixed: position x, y, z in m, velocity x, y, z, attitude from body to Earth-fixed axes. */
typedef struct {
    /** Latitude (north positive) and longitude (east positive), rad; height above the ellipsoid, m. */
    schuler_pair_f32 position[3];
    /** North, east, down, relative to the Earth, m/s. */
    schuler_pair_f32 velocity[3];
    /** Unit quaternion w, x, y, z from body axes to north, east, down. */
    schuler_pair_f32 attitude[4];
} schuler_solution_f32;

/** Rates at an instant, in body axes (forward, right, down). */
typedef struct {
    /** Angular rate against inertial space, rad/s. */
    float rate_ib_b[3];
    /** Specific force, m/s^2. */
    float specific_force_b[3];
} schuler_rates_f32;

/** The corrected state less the present one, in north, east and down. Zeros change no bit. */
typedef struct {
    /** Position, m, at most 10 km. */
    float position_ned[3];
    /** Velocity, m/s, at most 10 km/s. */
    float velocity_ned[3];
    /** Attitude as the rotation vector from the present to the corrected one, rad, at most half a turn. */
    float attitude_ned[3];
} schuler_correction_f32;

/** The navigator F32LocalLevel with the window H0B4A0, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[67];
} schuler_f32_local_level_h0b4a0_any;

/** The navigator F32LocalLevel with the window H2B4A2 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[86];
} schuler_f32_local_level_h2b4a2;

/** The navigator F32LocalLevel with the window H2B4A2, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[95];
} schuler_f32_local_level_h2b4a2_any;

/** The textbook's algorithm, F32LocalLevelTextbook: a step for every sample, of any length, without delay.
 * Its state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[19];
} schuler_f32_local_level_textbook;

/** The navigator F32EarthFixed with the window H0B4A0 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[63];
} schuler_f32_earth_fixed_h0b4a0;

/** The navigator F32EarthFixed with the window H0B4A0, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[67];
} schuler_f32_earth_fixed_h0b4a0_any;

/** The navigator F32EarthFixed with the window H2B4A2 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[87];
} schuler_f32_earth_fixed_h2b4a2;

/** The navigator F32EarthFixed with the window H2B4A2, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[95];
} schuler_f32_earth_fixed_h2b4a2_any;

/** The textbook's algorithm, F32EarthFixedTextbook: a step for every sample, of any length, without delay.
 * Its state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[18];
} schuler_f32_earth_fixed_textbook;

/** The navigator F32x2LocalLevel with the window H0B4A0 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[62];
} schuler_f32x2_local_level_h0b4a0;

/** The navigator F32x2LocalLevel with the window H0B4A0, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[67];
} schuler_f32x2_local_level_h0b4a0_any;

/** The navigator F32x2LocalLevel with the window H2B4A2 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[86];
} schuler_f32x2_local_level_h2b4a2;

/** The navigator F32x2LocalLevel with the window H2B4A2, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[95];
} schuler_f32x2_local_level_h2b4a2_any;

/** The navigator F32x2EarthFixed with the window H0B4A0 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[63];
} schuler_f32x2_earth_fixed_h0b4a0;

/** The navigator F32x2EarthFixed with the window H0B4A0, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[67];
} schuler_f32x2_earth_fixed_h0b4a0_any;

/** The navigator F32x2EarthFixed with the window H2B4A2 (history, block and look-ahead in samples). Its
 * state: allocate it anywhere, on the stack or statically, and pass it by pointer. The bytes are the
 * library's; a copy goes on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[87];
} schuler_f32x2_earth_fixed_h2b4a2;

/** The navigator F32x2EarthFixed with the window H2B4A2, for samples of any length. Its state: allocate it
 * anywhere, on the stack or statically, and pass it by pointer. The bytes are the library's; a copy goes
 * on by itself, bit for bit. */
typedef struct {
    /** The library's. */
    uint64_t opaque[95];
} schuler_f32x2_earth_fixed_h2b4a2_any;

/** The application of a target: it navigates what a host sends, with every navigator that the link knows.
 * Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[224];
} schuler_target;

/** Sends bytes, all of them. `context` is what the caller gave beside it. */
typedef void (*schuler_send)(void *context,
                             const uint8_t *bytes,
                             size_t count);

/** The application of a target: it navigates what a host sends, in single precision and local axes,
 * without a double. Allocate it anywhere. */
typedef struct {
    /** The library's. */
    uint64_t opaque[142];
} schuler_target_f32;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/** The version of the interface that the library was built with: SCHULER_ABI, if header and library fit. */
uint32_t schuler_abi(void);

/** Starts without samples. `piece_s` is the length of the pieces that tell noise from motion, s (1 suits);
 * `abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI or _INTERVAL. */
int32_t schuler_alignment_f32_start(schuler_alignment_f32 *alignment,
                                    uint32_t abi,
                                    float piece_s);

/** Adds a sample of increments at rest that lasts `interval_s`, s. Fails with SCHULER_REJECTED_INTERVAL,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes then. */
int32_t schuler_alignment_f32_add(schuler_alignment_f32 *alignment,
                                  const schuler_increment_f32 *sample,
                                  float interval_s);

/** Roll, pitch and yaw, rad: level by the accelerometers, north by the gyros. Fails with
 * SCHULER_ALIGNMENT_EMPTY, SCHULER_ALIGNMENT_UNDETERMINED, and as _add does; nothing is written then. */
int32_t schuler_alignment_f32_attitude(const schuler_alignment_f32 *alignment,
                                       schuler_vector_f32 *roll_pitch_yaw_rad);

/** Roll and pitch by the accelerometers, with a yaw that is known from elsewhere, rad. Fails as _attitude
 * does. */
int32_t schuler_alignment_f32_level(const schuler_alignment_f32 *alignment,
                                    float yaw_rad,
                                    schuler_vector_f32 *roll_pitch_yaw_rad);

/** What was read so far, judged for a vehicle at rest at a latitude, a longitude (rad) and a height (m).
 * Fails with SCHULER_ALIGNMENT_EMPTY, and as _add does; nothing is written then. */
int32_t schuler_alignment_f32_judge(const schuler_alignment_f32 *alignment,
                                    float latitude_rad,
                                    float longitude_rad,
                                    float altitude_m,
                                    schuler_still_f32 *still);

/** Starts without samples. `piece_s` is the length of the pieces that tell noise from motion, s (1 suits);
 * `abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI or _INTERVAL. */
int32_t schuler_alignment_f64_start(schuler_alignment_f64 *alignment,
                                    uint32_t abi,
                                    double piece_s);

/** Adds a sample of increments at rest that lasts `interval_s`, s. Fails with SCHULER_REJECTED_INTERVAL,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes then. */
int32_t schuler_alignment_f64_add(schuler_alignment_f64 *alignment,
                                  const schuler_increment_f64 *sample,
                                  double interval_s);

/** Roll, pitch and yaw, rad: level by the accelerometers, north by the gyros. Fails with
 * SCHULER_ALIGNMENT_EMPTY, SCHULER_ALIGNMENT_UNDETERMINED, and as _add does; nothing is written then. */
int32_t schuler_alignment_f64_attitude(const schuler_alignment_f64 *alignment,
                                       schuler_vector_f64 *roll_pitch_yaw_rad);

/** Roll and pitch by the accelerometers, with a yaw that is known from elsewhere, rad. Fails as _attitude
 * does. */
int32_t schuler_alignment_f64_level(const schuler_alignment_f64 *alignment,
                                    double yaw_rad,
                                    schuler_vector_f64 *roll_pitch_yaw_rad);

/** What was read so far, judged for a vehicle at rest at a latitude, a longitude (rad) and a height (m).
 * Fails with SCHULER_ALIGNMENT_EMPTY, and as _add does; nothing is written then. */
int32_t schuler_alignment_f64_judge(const schuler_alignment_f64 *alignment,
                                    double latitude_rad,
                                    double longitude_rad,
                                    double altitude_m,
                                    schuler_still_f64 *still);

/** Starts with nothing dropped; `abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI. */
int32_t schuler_carried_start(schuler_carried *carried,
                              uint32_t abi);

/** Rounds a sample to single precision: y = x + c, narrow = (float)y, c = y - narrow, for each of its
 * numbers. The rest c stays for the next sample, so that no rounding adds up. A sample that the navigator
 * then refuses has been carried all the same: copy the state before, and put the copy back. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes then. */
int32_t schuler_carried_narrow(schuler_carried *carried,
                               const schuler_increment_f64 *sample,
                               schuler_increment_f32 *narrow);

/** A number of two doubles as one of two floats, such as an interval. Fails with SCHULER_ERROR_NULL or
 * _MISALIGNED. */
int32_t schuler_pair_narrow(const schuler_pair_f64 *wide,
                            schuler_pair_f32 *narrow);

/** The interval of a rate in hertz, s, to twice the digits of a double. Fails with SCHULER_ERROR_NULL or
 * _MISALIGNED. */
int32_t schuler_interval_of(double rate_hz,
                            schuler_pair_f64 *interval_s);

/** Starts with no state; `abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI. */
int32_t schuler_digest_start(schuler_digest *digest,
                             uint32_t abi);

/** Adds a state: `count` words, each with the bits of a number in its low end, as a row of a chain has
 * them. Fails with SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes
 * then. */
int32_t schuler_digest_add(schuler_digest *digest,
                           const uint64_t *words,
                           size_t count);

/** The digest of everything so far: that of a chain's `#` and `=` lines. Fails as schuler_digest_add does. */
int32_t schuler_digest_value(const schuler_digest *digest,
                             uint64_t *value);

/** Starts a unit for samples of `interval_s`, s, in a run of `samples` (which matters to bias instability
 * alone). All that is random is a function of `seed` and `run`; `abi` is SCHULER_ABI. Fails with
 * SCHULER_PARAMETER_ and the parameter's name, SCHULER_ERROR_NULL, _MISALIGNED or _ABI; the unit is as it
 * was then. */
int32_t schuler_emulator_f32_start(schuler_emulator_f32 *emulator,
                                   uint32_t abi,
                                   float interval_s,
                                   uint64_t samples,
                                   const schuler_triad_f32 *gyros,
                                   const schuler_triad_f32 *accelerometers,
                                   uint64_t seed,
                                   uint64_t run);

/** What the unit reads in its next sample, given the true increments. `perfect` and `read` may be one.
 * Fails with SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes then. */
int32_t schuler_emulator_f32_read(schuler_emulator_f32 *emulator,
                                  const schuler_increment_f32 *perfect,
                                  schuler_increment_f32 *read);

/** Starts a unit for samples of `interval_s`, s, in a run of `samples` (which matters to bias instability
 * alone). All that is random is a function of `seed` and `run`; `abi` is SCHULER_ABI. Fails with
 * SCHULER_PARAMETER_ and the parameter's name, SCHULER_ERROR_NULL, _MISALIGNED or _ABI; the unit is as it
 * was then. */
int32_t schuler_emulator_f64_start(schuler_emulator_f64 *emulator,
                                   uint32_t abi,
                                   double interval_s,
                                   uint64_t samples,
                                   const schuler_triad_f64 *gyros,
                                   const schuler_triad_f64 *accelerometers,
                                   uint64_t seed,
                                   uint64_t run);

/** What the unit reads in its next sample, given the true increments. `perfect` and `read` may be one.
 * Fails with SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes then. */
int32_t schuler_emulator_f64_read(schuler_emulator_f64 *emulator,
                                  const schuler_increment_f64 *perfect,
                                  schuler_increment_f64 *read);

/** Starts with no bytes; `abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI. */
int32_t schuler_decoder_start(schuler_decoder *decoder,
                              uint32_t abi);

/** Takes the next byte. SCHULER_FRAME, 1: it completes a frame, which is written to `frame`. SCHULER_OK:
 * it does not; a damaged frame counts as none. Fails with SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED,
 * _FOREIGN or _STALE; nothing changes then. */
int32_t schuler_decoder_take(schuler_decoder *decoder,
                             uint8_t byte,
                             schuler_frame *frame);

/** Writes a frame for the line: `kind`, a code of the core's `link::kind`, the sender's number of the
 * frame, a sample's time in ns, and `length` bytes of payload, to the front of `room` bytes; `written`
 * gets how many they are. Fails with SCHULER_ERROR_NULL, _MISALIGNED, _KIND, _PAYLOAD or _SPACE; nothing
 * is written then. */
int32_t schuler_encode(uint32_t kind,
                       uint32_t sequence,
                       uint64_t time_ns,
                       const uint8_t *payload,
                       size_t length,
                       uint8_t *encoded,
                       size_t room,
                       size_t *written);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_start(schuler_f64_local_level_h0b4a0 *state,
                                             uint32_t abi,
                                             double rate_hz,
                                             uint32_t order,
                                             const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_local_level_h0b4a0_start_own(schuler_f64_local_level_h0b4a0 *state,
                                                 uint32_t abi,
                                                 const schuler_pair_f64 *interval_s,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_LOCAL_LEVEL_H0B4A0_SAVED of them, to the front of `length`. Fails with SCHULER_ERROR_SPACE,
 * and as _finish does; nothing is written then. */
int32_t schuler_f64_local_level_h0b4a0_save(const schuler_f64_local_level_h0b4a0 *state,
                                            uint8_t *bytes,
                                            size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_restore(schuler_f64_local_level_h0b4a0 *state,
                                               uint32_t abi,
                                               const uint8_t *stored,
                                               size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_local_level_h0b4a0_forget(schuler_f64_local_level_h0b4a0 *state);

/** Bytes that the library needs of a schuler_f64_local_level_h0b4a0: at most its size. */
size_t schuler_f64_local_level_h0b4a0_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_push(schuler_f64_local_level_h0b4a0 *state,
                                            const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_local_level_h0b4a0_push_rates(schuler_f64_local_level_h0b4a0 *state,
                                                  const schuler_rates_f64 *at_start,
                                                  const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_local_level_h0b4a0_finish(schuler_f64_local_level_h0b4a0 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_correct(schuler_f64_local_level_h0b4a0 *state,
                                               const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_hold_vertical(schuler_f64_local_level_h0b4a0 *state,
                                                     double altitude_m,
                                                     double down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_read(const schuler_f64_local_level_h0b4a0 *state,
                                            schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_local_level_h0b4a0_read_own(const schuler_f64_local_level_h0b4a0 *state,
                                                schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_predict(const schuler_f64_local_level_h0b4a0 *state,
                                               schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_local_level_h0b4a0_predict_own(const schuler_f64_local_level_h0b4a0 *state,
                                                   schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_local_level_h0b4a0_integrated(const schuler_f64_local_level_h0b4a0 *state,
                                                  uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_local_level_h0b4a0_digest(const schuler_f64_local_level_h0b4a0 *state,
                                              schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_local_level_h0b4a0_digest_end(const schuler_f64_local_level_h0b4a0 *state,
                                                  schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_any_start(schuler_f64_local_level_h0b4a0_any *state,
                                                 uint32_t abi,
                                                 double rate_hz,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_local_level_h0b4a0_any_start_own(schuler_f64_local_level_h0b4a0_any *state,
                                                     uint32_t abi,
                                                     const schuler_pair_f64 *interval_s,
                                                     uint32_t order,
                                                     const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_LOCAL_LEVEL_H0B4A0_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f64_local_level_h0b4a0_any_save(const schuler_f64_local_level_h0b4a0_any *state,
                                                uint8_t *bytes,
                                                size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_any_restore(schuler_f64_local_level_h0b4a0_any *state,
                                                   uint32_t abi,
                                                   const uint8_t *stored,
                                                   size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_local_level_h0b4a0_any_forget(schuler_f64_local_level_h0b4a0_any *state);

/** Bytes that the library needs of a schuler_f64_local_level_h0b4a0_any: at most its size. */
size_t schuler_f64_local_level_h0b4a0_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_any_push(schuler_f64_local_level_h0b4a0_any *state,
                                                const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_local_level_h0b4a0_any_push_rates(schuler_f64_local_level_h0b4a0_any *state,
                                                      const schuler_rates_f64 *at_start,
                                                      const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_local_level_h0b4a0_any_finish(schuler_f64_local_level_h0b4a0_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_any_correct(schuler_f64_local_level_h0b4a0_any *state,
                                                   const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_any_hold_vertical(schuler_f64_local_level_h0b4a0_any *state,
                                                         double altitude_m,
                                                         double down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f64_local_level_h0b4a0_any_push_over(schuler_f64_local_level_h0b4a0_any *state,
                                                     const schuler_increment_f64 *sample,
                                                     const schuler_pair_f64 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f64_local_level_h0b4a0_any_push_rates_over(schuler_f64_local_level_h0b4a0_any *state,
                                                           const schuler_rates_f64 *at_start,
                                                           const schuler_rates_f64 *at_end,
                                                           const schuler_pair_f64 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_any_read(const schuler_f64_local_level_h0b4a0_any *state,
                                                schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_local_level_h0b4a0_any_read_own(const schuler_f64_local_level_h0b4a0_any *state,
                                                    schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_h0b4a0_any_predict(const schuler_f64_local_level_h0b4a0_any *state,
                                                   schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_local_level_h0b4a0_any_predict_own(const schuler_f64_local_level_h0b4a0_any *state,
                                                       schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_local_level_h0b4a0_any_integrated(const schuler_f64_local_level_h0b4a0_any *state,
                                                      uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_local_level_h0b4a0_any_digest(const schuler_f64_local_level_h0b4a0_any *state,
                                                  schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_local_level_h0b4a0_any_digest_end(const schuler_f64_local_level_h0b4a0_any *state,
                                                      schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_start(schuler_f64_local_level_h2b4a2 *state,
                                             uint32_t abi,
                                             double rate_hz,
                                             uint32_t order,
                                             const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_local_level_h2b4a2_start_own(schuler_f64_local_level_h2b4a2 *state,
                                                 uint32_t abi,
                                                 const schuler_pair_f64 *interval_s,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_LOCAL_LEVEL_H2B4A2_SAVED of them, to the front of `length`. Fails with SCHULER_ERROR_SPACE,
 * and as _finish does; nothing is written then. */
int32_t schuler_f64_local_level_h2b4a2_save(const schuler_f64_local_level_h2b4a2 *state,
                                            uint8_t *bytes,
                                            size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_restore(schuler_f64_local_level_h2b4a2 *state,
                                               uint32_t abi,
                                               const uint8_t *stored,
                                               size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_local_level_h2b4a2_forget(schuler_f64_local_level_h2b4a2 *state);

/** Bytes that the library needs of a schuler_f64_local_level_h2b4a2: at most its size. */
size_t schuler_f64_local_level_h2b4a2_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_push(schuler_f64_local_level_h2b4a2 *state,
                                            const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_local_level_h2b4a2_push_rates(schuler_f64_local_level_h2b4a2 *state,
                                                  const schuler_rates_f64 *at_start,
                                                  const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_local_level_h2b4a2_finish(schuler_f64_local_level_h2b4a2 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_correct(schuler_f64_local_level_h2b4a2 *state,
                                               const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_hold_vertical(schuler_f64_local_level_h2b4a2 *state,
                                                     double altitude_m,
                                                     double down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_read(const schuler_f64_local_level_h2b4a2 *state,
                                            schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_local_level_h2b4a2_read_own(const schuler_f64_local_level_h2b4a2 *state,
                                                schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_predict(const schuler_f64_local_level_h2b4a2 *state,
                                               schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_local_level_h2b4a2_predict_own(const schuler_f64_local_level_h2b4a2 *state,
                                                   schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_local_level_h2b4a2_integrated(const schuler_f64_local_level_h2b4a2 *state,
                                                  uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_local_level_h2b4a2_digest(const schuler_f64_local_level_h2b4a2 *state,
                                              schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_local_level_h2b4a2_digest_end(const schuler_f64_local_level_h2b4a2 *state,
                                                  schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_any_start(schuler_f64_local_level_h2b4a2_any *state,
                                                 uint32_t abi,
                                                 double rate_hz,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_local_level_h2b4a2_any_start_own(schuler_f64_local_level_h2b4a2_any *state,
                                                     uint32_t abi,
                                                     const schuler_pair_f64 *interval_s,
                                                     uint32_t order,
                                                     const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_LOCAL_LEVEL_H2B4A2_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f64_local_level_h2b4a2_any_save(const schuler_f64_local_level_h2b4a2_any *state,
                                                uint8_t *bytes,
                                                size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_any_restore(schuler_f64_local_level_h2b4a2_any *state,
                                                   uint32_t abi,
                                                   const uint8_t *stored,
                                                   size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_local_level_h2b4a2_any_forget(schuler_f64_local_level_h2b4a2_any *state);

/** Bytes that the library needs of a schuler_f64_local_level_h2b4a2_any: at most its size. */
size_t schuler_f64_local_level_h2b4a2_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_any_push(schuler_f64_local_level_h2b4a2_any *state,
                                                const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_local_level_h2b4a2_any_push_rates(schuler_f64_local_level_h2b4a2_any *state,
                                                      const schuler_rates_f64 *at_start,
                                                      const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_local_level_h2b4a2_any_finish(schuler_f64_local_level_h2b4a2_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_any_correct(schuler_f64_local_level_h2b4a2_any *state,
                                                   const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_any_hold_vertical(schuler_f64_local_level_h2b4a2_any *state,
                                                         double altitude_m,
                                                         double down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f64_local_level_h2b4a2_any_push_over(schuler_f64_local_level_h2b4a2_any *state,
                                                     const schuler_increment_f64 *sample,
                                                     const schuler_pair_f64 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f64_local_level_h2b4a2_any_push_rates_over(schuler_f64_local_level_h2b4a2_any *state,
                                                           const schuler_rates_f64 *at_start,
                                                           const schuler_rates_f64 *at_end,
                                                           const schuler_pair_f64 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_any_read(const schuler_f64_local_level_h2b4a2_any *state,
                                                schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_local_level_h2b4a2_any_read_own(const schuler_f64_local_level_h2b4a2_any *state,
                                                    schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_h2b4a2_any_predict(const schuler_f64_local_level_h2b4a2_any *state,
                                                   schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_local_level_h2b4a2_any_predict_own(const schuler_f64_local_level_h2b4a2_any *state,
                                                       schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_local_level_h2b4a2_any_integrated(const schuler_f64_local_level_h2b4a2_any *state,
                                                      uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_local_level_h2b4a2_any_digest(const schuler_f64_local_level_h2b4a2_any *state,
                                                  schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_local_level_h2b4a2_any_digest_end(const schuler_f64_local_level_h2b4a2_any *state,
                                                      schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_local_level_textbook_start(schuler_f64_local_level_textbook *state,
                                               uint32_t abi,
                                               double rate_hz,
                                               uint32_t order,
                                               const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_local_level_textbook_start_own(schuler_f64_local_level_textbook *state,
                                                   uint32_t abi,
                                                   const schuler_pair_f64 *interval_s,
                                                   uint32_t order,
                                                   const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_LOCAL_LEVEL_TEXTBOOK_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f64_local_level_textbook_save(const schuler_f64_local_level_textbook *state,
                                              uint8_t *bytes,
                                              size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_local_level_textbook_restore(schuler_f64_local_level_textbook *state,
                                                 uint32_t abi,
                                                 const uint8_t *stored,
                                                 size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_local_level_textbook_forget(schuler_f64_local_level_textbook *state);

/** Bytes that the library needs of a schuler_f64_local_level_textbook: at most its size. */
size_t schuler_f64_local_level_textbook_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_local_level_textbook_push(schuler_f64_local_level_textbook *state,
                                              const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_local_level_textbook_push_rates(schuler_f64_local_level_textbook *state,
                                                    const schuler_rates_f64 *at_start,
                                                    const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_local_level_textbook_finish(schuler_f64_local_level_textbook *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_textbook_correct(schuler_f64_local_level_textbook *state,
                                                 const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_local_level_textbook_hold_vertical(schuler_f64_local_level_textbook *state,
                                                       double altitude_m,
                                                       double down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f64_local_level_textbook_push_over(schuler_f64_local_level_textbook *state,
                                                   const schuler_increment_f64 *sample,
                                                   const schuler_pair_f64 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f64_local_level_textbook_push_rates_over(schuler_f64_local_level_textbook *state,
                                                         const schuler_rates_f64 *at_start,
                                                         const schuler_rates_f64 *at_end,
                                                         const schuler_pair_f64 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_textbook_read(const schuler_f64_local_level_textbook *state,
                                              schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_local_level_textbook_read_own(const schuler_f64_local_level_textbook *state,
                                                  schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_local_level_textbook_predict(const schuler_f64_local_level_textbook *state,
                                                 schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_local_level_textbook_predict_own(const schuler_f64_local_level_textbook *state,
                                                     schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_local_level_textbook_integrated(const schuler_f64_local_level_textbook *state,
                                                    uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_local_level_textbook_digest(const schuler_f64_local_level_textbook *state,
                                                schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_local_level_textbook_digest_end(const schuler_f64_local_level_textbook *state,
                                                    schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_start(schuler_f64_earth_fixed_h0b4a0 *state,
                                             uint32_t abi,
                                             double rate_hz,
                                             uint32_t order,
                                             const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_earth_fixed_h0b4a0_start_own(schuler_f64_earth_fixed_h0b4a0 *state,
                                                 uint32_t abi,
                                                 const schuler_pair_f64 *interval_s,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_EARTH_FIXED_H0B4A0_SAVED of them, to the front of `length`. Fails with SCHULER_ERROR_SPACE,
 * and as _finish does; nothing is written then. */
int32_t schuler_f64_earth_fixed_h0b4a0_save(const schuler_f64_earth_fixed_h0b4a0 *state,
                                            uint8_t *bytes,
                                            size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_restore(schuler_f64_earth_fixed_h0b4a0 *state,
                                               uint32_t abi,
                                               const uint8_t *stored,
                                               size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_earth_fixed_h0b4a0_forget(schuler_f64_earth_fixed_h0b4a0 *state);

/** Bytes that the library needs of a schuler_f64_earth_fixed_h0b4a0: at most its size. */
size_t schuler_f64_earth_fixed_h0b4a0_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_push(schuler_f64_earth_fixed_h0b4a0 *state,
                                            const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_earth_fixed_h0b4a0_push_rates(schuler_f64_earth_fixed_h0b4a0 *state,
                                                  const schuler_rates_f64 *at_start,
                                                  const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_earth_fixed_h0b4a0_finish(schuler_f64_earth_fixed_h0b4a0 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_correct(schuler_f64_earth_fixed_h0b4a0 *state,
                                               const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_hold_vertical(schuler_f64_earth_fixed_h0b4a0 *state,
                                                     double altitude_m,
                                                     double down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_read(const schuler_f64_earth_fixed_h0b4a0 *state,
                                            schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_earth_fixed_h0b4a0_read_own(const schuler_f64_earth_fixed_h0b4a0 *state,
                                                schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_predict(const schuler_f64_earth_fixed_h0b4a0 *state,
                                               schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_earth_fixed_h0b4a0_predict_own(const schuler_f64_earth_fixed_h0b4a0 *state,
                                                   schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_earth_fixed_h0b4a0_integrated(const schuler_f64_earth_fixed_h0b4a0 *state,
                                                  uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_earth_fixed_h0b4a0_digest(const schuler_f64_earth_fixed_h0b4a0 *state,
                                              schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_earth_fixed_h0b4a0_digest_end(const schuler_f64_earth_fixed_h0b4a0 *state,
                                                  schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_start(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                 uint32_t abi,
                                                 double rate_hz,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_start_own(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                     uint32_t abi,
                                                     const schuler_pair_f64 *interval_s,
                                                     uint32_t order,
                                                     const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_EARTH_FIXED_H0B4A0_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_save(const schuler_f64_earth_fixed_h0b4a0_any *state,
                                                uint8_t *bytes,
                                                size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_restore(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                   uint32_t abi,
                                                   const uint8_t *stored,
                                                   size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_forget(schuler_f64_earth_fixed_h0b4a0_any *state);

/** Bytes that the library needs of a schuler_f64_earth_fixed_h0b4a0_any: at most its size. */
size_t schuler_f64_earth_fixed_h0b4a0_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_push(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_push_rates(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                      const schuler_rates_f64 *at_start,
                                                      const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_finish(schuler_f64_earth_fixed_h0b4a0_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_correct(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                   const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_hold_vertical(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                         double altitude_m,
                                                         double down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_push_over(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                     const schuler_increment_f64 *sample,
                                                     const schuler_pair_f64 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_push_rates_over(schuler_f64_earth_fixed_h0b4a0_any *state,
                                                           const schuler_rates_f64 *at_start,
                                                           const schuler_rates_f64 *at_end,
                                                           const schuler_pair_f64 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_read(const schuler_f64_earth_fixed_h0b4a0_any *state,
                                                schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_read_own(const schuler_f64_earth_fixed_h0b4a0_any *state,
                                                    schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_predict(const schuler_f64_earth_fixed_h0b4a0_any *state,
                                                   schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_predict_own(const schuler_f64_earth_fixed_h0b4a0_any *state,
                                                       schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_integrated(const schuler_f64_earth_fixed_h0b4a0_any *state,
                                                      uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_digest(const schuler_f64_earth_fixed_h0b4a0_any *state,
                                                  schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_earth_fixed_h0b4a0_any_digest_end(const schuler_f64_earth_fixed_h0b4a0_any *state,
                                                      schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_start(schuler_f64_earth_fixed_h2b4a2 *state,
                                             uint32_t abi,
                                             double rate_hz,
                                             uint32_t order,
                                             const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_earth_fixed_h2b4a2_start_own(schuler_f64_earth_fixed_h2b4a2 *state,
                                                 uint32_t abi,
                                                 const schuler_pair_f64 *interval_s,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_EARTH_FIXED_H2B4A2_SAVED of them, to the front of `length`. Fails with SCHULER_ERROR_SPACE,
 * and as _finish does; nothing is written then. */
int32_t schuler_f64_earth_fixed_h2b4a2_save(const schuler_f64_earth_fixed_h2b4a2 *state,
                                            uint8_t *bytes,
                                            size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_restore(schuler_f64_earth_fixed_h2b4a2 *state,
                                               uint32_t abi,
                                               const uint8_t *stored,
                                               size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_earth_fixed_h2b4a2_forget(schuler_f64_earth_fixed_h2b4a2 *state);

/** Bytes that the library needs of a schuler_f64_earth_fixed_h2b4a2: at most its size. */
size_t schuler_f64_earth_fixed_h2b4a2_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_push(schuler_f64_earth_fixed_h2b4a2 *state,
                                            const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_earth_fixed_h2b4a2_push_rates(schuler_f64_earth_fixed_h2b4a2 *state,
                                                  const schuler_rates_f64 *at_start,
                                                  const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_earth_fixed_h2b4a2_finish(schuler_f64_earth_fixed_h2b4a2 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_correct(schuler_f64_earth_fixed_h2b4a2 *state,
                                               const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_hold_vertical(schuler_f64_earth_fixed_h2b4a2 *state,
                                                     double altitude_m,
                                                     double down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_read(const schuler_f64_earth_fixed_h2b4a2 *state,
                                            schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_earth_fixed_h2b4a2_read_own(const schuler_f64_earth_fixed_h2b4a2 *state,
                                                schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_predict(const schuler_f64_earth_fixed_h2b4a2 *state,
                                               schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_earth_fixed_h2b4a2_predict_own(const schuler_f64_earth_fixed_h2b4a2 *state,
                                                   schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_earth_fixed_h2b4a2_integrated(const schuler_f64_earth_fixed_h2b4a2 *state,
                                                  uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_earth_fixed_h2b4a2_digest(const schuler_f64_earth_fixed_h2b4a2 *state,
                                              schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_earth_fixed_h2b4a2_digest_end(const schuler_f64_earth_fixed_h2b4a2 *state,
                                                  schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_start(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                 uint32_t abi,
                                                 double rate_hz,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_start_own(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                     uint32_t abi,
                                                     const schuler_pair_f64 *interval_s,
                                                     uint32_t order,
                                                     const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_EARTH_FIXED_H2B4A2_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_save(const schuler_f64_earth_fixed_h2b4a2_any *state,
                                                uint8_t *bytes,
                                                size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_restore(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                   uint32_t abi,
                                                   const uint8_t *stored,
                                                   size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_forget(schuler_f64_earth_fixed_h2b4a2_any *state);

/** Bytes that the library needs of a schuler_f64_earth_fixed_h2b4a2_any: at most its size. */
size_t schuler_f64_earth_fixed_h2b4a2_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_push(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_push_rates(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                      const schuler_rates_f64 *at_start,
                                                      const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_finish(schuler_f64_earth_fixed_h2b4a2_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_correct(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                   const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_hold_vertical(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                         double altitude_m,
                                                         double down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_push_over(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                     const schuler_increment_f64 *sample,
                                                     const schuler_pair_f64 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_push_rates_over(schuler_f64_earth_fixed_h2b4a2_any *state,
                                                           const schuler_rates_f64 *at_start,
                                                           const schuler_rates_f64 *at_end,
                                                           const schuler_pair_f64 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_read(const schuler_f64_earth_fixed_h2b4a2_any *state,
                                                schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_read_own(const schuler_f64_earth_fixed_h2b4a2_any *state,
                                                    schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_predict(const schuler_f64_earth_fixed_h2b4a2_any *state,
                                                   schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_predict_own(const schuler_f64_earth_fixed_h2b4a2_any *state,
                                                       schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_integrated(const schuler_f64_earth_fixed_h2b4a2_any *state,
                                                      uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_digest(const schuler_f64_earth_fixed_h2b4a2_any *state,
                                                  schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_earth_fixed_h2b4a2_any_digest_end(const schuler_f64_earth_fixed_h2b4a2_any *state,
                                                      schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f64_earth_fixed_textbook_start(schuler_f64_earth_fixed_textbook *state,
                                               uint32_t abi,
                                               double rate_hz,
                                               uint32_t order,
                                               const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f64_earth_fixed_textbook_start_own(schuler_f64_earth_fixed_textbook *state,
                                                   uint32_t abi,
                                                   const schuler_pair_f64 *interval_s,
                                                   uint32_t order,
                                                   const schuler_solution_f64 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F64_EARTH_FIXED_TEXTBOOK_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f64_earth_fixed_textbook_save(const schuler_f64_earth_fixed_textbook *state,
                                              uint8_t *bytes,
                                              size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f64_earth_fixed_textbook_restore(schuler_f64_earth_fixed_textbook *state,
                                                 uint32_t abi,
                                                 const uint8_t *stored,
                                                 size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f64_earth_fixed_textbook_forget(schuler_f64_earth_fixed_textbook *state);

/** Bytes that the library needs of a schuler_f64_earth_fixed_textbook: at most its size. */
size_t schuler_f64_earth_fixed_textbook_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f64_earth_fixed_textbook_push(schuler_f64_earth_fixed_textbook *state,
                                              const schuler_increment_f64 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f64_earth_fixed_textbook_push_rates(schuler_f64_earth_fixed_textbook *state,
                                                    const schuler_rates_f64 *at_start,
                                                    const schuler_rates_f64 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f64_earth_fixed_textbook_finish(schuler_f64_earth_fixed_textbook *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_textbook_correct(schuler_f64_earth_fixed_textbook *state,
                                                 const schuler_correction_f64 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f64_earth_fixed_textbook_hold_vertical(schuler_f64_earth_fixed_textbook *state,
                                                       double altitude_m,
                                                       double down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f64_earth_fixed_textbook_push_over(schuler_f64_earth_fixed_textbook *state,
                                                   const schuler_increment_f64 *sample,
                                                   const schuler_pair_f64 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f64_earth_fixed_textbook_push_rates_over(schuler_f64_earth_fixed_textbook *state,
                                                         const schuler_rates_f64 *at_start,
                                                         const schuler_rates_f64 *at_end,
                                                         const schuler_pair_f64 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_textbook_read(const schuler_f64_earth_fixed_textbook *state,
                                              schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f64_earth_fixed_textbook_read_own(const schuler_f64_earth_fixed_textbook *state,
                                                  schuler_solution_f64 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f64_earth_fixed_textbook_predict(const schuler_f64_earth_fixed_textbook *state,
                                                 schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f64_earth_fixed_textbook_predict_own(const schuler_f64_earth_fixed_textbook *state,
                                                     schuler_solution_f64 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f64_earth_fixed_textbook_integrated(const schuler_f64_earth_fixed_textbook *state,
                                                    uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f64_earth_fixed_textbook_digest(const schuler_f64_earth_fixed_textbook *state,
                                                schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f64_earth_fixed_textbook_digest_end(const schuler_f64_earth_fixed_textbook *state,
                                                    schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_start(schuler_f32_local_level_h0b4a0 *state,
                                             uint32_t abi,
                                             double rate_hz,
                                             uint32_t order,
                                             const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_local_level_h0b4a0_start_own(schuler_f32_local_level_h0b4a0 *state,
                                                 uint32_t abi,
                                                 const schuler_pair_f32 *interval_s,
                                                 uint32_t order,
                                                 const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_LOCAL_LEVEL_H0B4A0_SAVED of them, to the front of `length`. Fails with SCHULER_ERROR_SPACE,
 * and as _finish does; nothing is written then. */
int32_t schuler_f32_local_level_h0b4a0_save(const schuler_f32_local_level_h0b4a0 *state,
                                            uint8_t *bytes,
                                            size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_restore(schuler_f32_local_level_h0b4a0 *state,
                                               uint32_t abi,
                                               const uint8_t *stored,
                                               size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_local_level_h0b4a0_forget(schuler_f32_local_level_h0b4a0 *state);

/** Bytes that the library needs of a schuler_f32_local_level_h0b4a0: at most its size. */
size_t schuler_f32_local_level_h0b4a0_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_push(schuler_f32_local_level_h0b4a0 *state,
                                            const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_local_level_h0b4a0_push_rates(schuler_f32_local_level_h0b4a0 *state,
                                                  const schuler_rates_f32 *at_start,
                                                  const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_local_level_h0b4a0_finish(schuler_f32_local_level_h0b4a0 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_correct(schuler_f32_local_level_h0b4a0 *state,
                                               const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_hold_vertical(schuler_f32_local_level_h0b4a0 *state,
                                                     float altitude_m,
                                                     float down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_read(const schuler_f32_local_level_h0b4a0 *state,
                                            schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_local_level_h0b4a0_read_own(const schuler_f32_local_level_h0b4a0 *state,
                                                schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_predict(const schuler_f32_local_level_h0b4a0 *state,
                                               schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_local_level_h0b4a0_predict_own(const schuler_f32_local_level_h0b4a0 *state,
                                                   schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_local_level_h0b4a0_integrated(const schuler_f32_local_level_h0b4a0 *state,
                                                  uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_local_level_h0b4a0_digest(const schuler_f32_local_level_h0b4a0 *state,
                                              schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_local_level_h0b4a0_digest_end(const schuler_f32_local_level_h0b4a0 *state,
                                                  schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_any_start(schuler_f32_local_level_h0b4a0_any *state,
                                                 uint32_t abi,
                                                 double rate_hz,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_local_level_h0b4a0_any_start_own(schuler_f32_local_level_h0b4a0_any *state,
                                                     uint32_t abi,
                                                     const schuler_pair_f32 *interval_s,
                                                     uint32_t order,
                                                     const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_LOCAL_LEVEL_H0B4A0_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32_local_level_h0b4a0_any_save(const schuler_f32_local_level_h0b4a0_any *state,
                                                uint8_t *bytes,
                                                size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_any_restore(schuler_f32_local_level_h0b4a0_any *state,
                                                   uint32_t abi,
                                                   const uint8_t *stored,
                                                   size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_local_level_h0b4a0_any_forget(schuler_f32_local_level_h0b4a0_any *state);

/** Bytes that the library needs of a schuler_f32_local_level_h0b4a0_any: at most its size. */
size_t schuler_f32_local_level_h0b4a0_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_any_push(schuler_f32_local_level_h0b4a0_any *state,
                                                const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_local_level_h0b4a0_any_push_rates(schuler_f32_local_level_h0b4a0_any *state,
                                                      const schuler_rates_f32 *at_start,
                                                      const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_local_level_h0b4a0_any_finish(schuler_f32_local_level_h0b4a0_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_any_correct(schuler_f32_local_level_h0b4a0_any *state,
                                                   const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_any_hold_vertical(schuler_f32_local_level_h0b4a0_any *state,
                                                         float altitude_m,
                                                         float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32_local_level_h0b4a0_any_push_over(schuler_f32_local_level_h0b4a0_any *state,
                                                     const schuler_increment_f32 *sample,
                                                     const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32_local_level_h0b4a0_any_push_rates_over(schuler_f32_local_level_h0b4a0_any *state,
                                                           const schuler_rates_f32 *at_start,
                                                           const schuler_rates_f32 *at_end,
                                                           const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_any_read(const schuler_f32_local_level_h0b4a0_any *state,
                                                schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_local_level_h0b4a0_any_read_own(const schuler_f32_local_level_h0b4a0_any *state,
                                                    schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_h0b4a0_any_predict(const schuler_f32_local_level_h0b4a0_any *state,
                                                   schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_local_level_h0b4a0_any_predict_own(const schuler_f32_local_level_h0b4a0_any *state,
                                                       schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_local_level_h0b4a0_any_integrated(const schuler_f32_local_level_h0b4a0_any *state,
                                                      uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_local_level_h0b4a0_any_digest(const schuler_f32_local_level_h0b4a0_any *state,
                                                  schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_local_level_h0b4a0_any_digest_end(const schuler_f32_local_level_h0b4a0_any *state,
                                                      schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_start(schuler_f32_local_level_h2b4a2 *state,
                                             uint32_t abi,
                                             double rate_hz,
                                             uint32_t order,
                                             const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_local_level_h2b4a2_start_own(schuler_f32_local_level_h2b4a2 *state,
                                                 uint32_t abi,
                                                 const schuler_pair_f32 *interval_s,
                                                 uint32_t order,
                                                 const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_LOCAL_LEVEL_H2B4A2_SAVED of them, to the front of `length`. Fails with SCHULER_ERROR_SPACE,
 * and as _finish does; nothing is written then. */
int32_t schuler_f32_local_level_h2b4a2_save(const schuler_f32_local_level_h2b4a2 *state,
                                            uint8_t *bytes,
                                            size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_restore(schuler_f32_local_level_h2b4a2 *state,
                                               uint32_t abi,
                                               const uint8_t *stored,
                                               size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_local_level_h2b4a2_forget(schuler_f32_local_level_h2b4a2 *state);

/** Bytes that the library needs of a schuler_f32_local_level_h2b4a2: at most its size. */
size_t schuler_f32_local_level_h2b4a2_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_push(schuler_f32_local_level_h2b4a2 *state,
                                            const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_local_level_h2b4a2_push_rates(schuler_f32_local_level_h2b4a2 *state,
                                                  const schuler_rates_f32 *at_start,
                                                  const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_local_level_h2b4a2_finish(schuler_f32_local_level_h2b4a2 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_correct(schuler_f32_local_level_h2b4a2 *state,
                                               const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_hold_vertical(schuler_f32_local_level_h2b4a2 *state,
                                                     float altitude_m,
                                                     float down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_read(const schuler_f32_local_level_h2b4a2 *state,
                                            schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_local_level_h2b4a2_read_own(const schuler_f32_local_level_h2b4a2 *state,
                                                schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_predict(const schuler_f32_local_level_h2b4a2 *state,
                                               schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_local_level_h2b4a2_predict_own(const schuler_f32_local_level_h2b4a2 *state,
                                                   schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_local_level_h2b4a2_integrated(const schuler_f32_local_level_h2b4a2 *state,
                                                  uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_local_level_h2b4a2_digest(const schuler_f32_local_level_h2b4a2 *state,
                                              schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_local_level_h2b4a2_digest_end(const schuler_f32_local_level_h2b4a2 *state,
                                                  schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_any_start(schuler_f32_local_level_h2b4a2_any *state,
                                                 uint32_t abi,
                                                 double rate_hz,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_local_level_h2b4a2_any_start_own(schuler_f32_local_level_h2b4a2_any *state,
                                                     uint32_t abi,
                                                     const schuler_pair_f32 *interval_s,
                                                     uint32_t order,
                                                     const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_LOCAL_LEVEL_H2B4A2_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32_local_level_h2b4a2_any_save(const schuler_f32_local_level_h2b4a2_any *state,
                                                uint8_t *bytes,
                                                size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_any_restore(schuler_f32_local_level_h2b4a2_any *state,
                                                   uint32_t abi,
                                                   const uint8_t *stored,
                                                   size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_local_level_h2b4a2_any_forget(schuler_f32_local_level_h2b4a2_any *state);

/** Bytes that the library needs of a schuler_f32_local_level_h2b4a2_any: at most its size. */
size_t schuler_f32_local_level_h2b4a2_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_any_push(schuler_f32_local_level_h2b4a2_any *state,
                                                const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_local_level_h2b4a2_any_push_rates(schuler_f32_local_level_h2b4a2_any *state,
                                                      const schuler_rates_f32 *at_start,
                                                      const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_local_level_h2b4a2_any_finish(schuler_f32_local_level_h2b4a2_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_any_correct(schuler_f32_local_level_h2b4a2_any *state,
                                                   const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_any_hold_vertical(schuler_f32_local_level_h2b4a2_any *state,
                                                         float altitude_m,
                                                         float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32_local_level_h2b4a2_any_push_over(schuler_f32_local_level_h2b4a2_any *state,
                                                     const schuler_increment_f32 *sample,
                                                     const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32_local_level_h2b4a2_any_push_rates_over(schuler_f32_local_level_h2b4a2_any *state,
                                                           const schuler_rates_f32 *at_start,
                                                           const schuler_rates_f32 *at_end,
                                                           const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_any_read(const schuler_f32_local_level_h2b4a2_any *state,
                                                schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_local_level_h2b4a2_any_read_own(const schuler_f32_local_level_h2b4a2_any *state,
                                                    schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_h2b4a2_any_predict(const schuler_f32_local_level_h2b4a2_any *state,
                                                   schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_local_level_h2b4a2_any_predict_own(const schuler_f32_local_level_h2b4a2_any *state,
                                                       schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_local_level_h2b4a2_any_integrated(const schuler_f32_local_level_h2b4a2_any *state,
                                                      uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_local_level_h2b4a2_any_digest(const schuler_f32_local_level_h2b4a2_any *state,
                                                  schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_local_level_h2b4a2_any_digest_end(const schuler_f32_local_level_h2b4a2_any *state,
                                                      schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_local_level_textbook_start(schuler_f32_local_level_textbook *state,
                                               uint32_t abi,
                                               double rate_hz,
                                               uint32_t order,
                                               const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_local_level_textbook_start_own(schuler_f32_local_level_textbook *state,
                                                   uint32_t abi,
                                                   const schuler_pair_f32 *interval_s,
                                                   uint32_t order,
                                                   const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_LOCAL_LEVEL_TEXTBOOK_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32_local_level_textbook_save(const schuler_f32_local_level_textbook *state,
                                              uint8_t *bytes,
                                              size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_local_level_textbook_restore(schuler_f32_local_level_textbook *state,
                                                 uint32_t abi,
                                                 const uint8_t *stored,
                                                 size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_local_level_textbook_forget(schuler_f32_local_level_textbook *state);

/** Bytes that the library needs of a schuler_f32_local_level_textbook: at most its size. */
size_t schuler_f32_local_level_textbook_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_local_level_textbook_push(schuler_f32_local_level_textbook *state,
                                              const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_local_level_textbook_push_rates(schuler_f32_local_level_textbook *state,
                                                    const schuler_rates_f32 *at_start,
                                                    const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_local_level_textbook_finish(schuler_f32_local_level_textbook *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_textbook_correct(schuler_f32_local_level_textbook *state,
                                                 const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_local_level_textbook_hold_vertical(schuler_f32_local_level_textbook *state,
                                                       float altitude_m,
                                                       float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32_local_level_textbook_push_over(schuler_f32_local_level_textbook *state,
                                                   const schuler_increment_f32 *sample,
                                                   const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32_local_level_textbook_push_rates_over(schuler_f32_local_level_textbook *state,
                                                         const schuler_rates_f32 *at_start,
                                                         const schuler_rates_f32 *at_end,
                                                         const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_textbook_read(const schuler_f32_local_level_textbook *state,
                                              schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_local_level_textbook_read_own(const schuler_f32_local_level_textbook *state,
                                                  schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_local_level_textbook_predict(const schuler_f32_local_level_textbook *state,
                                                 schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_local_level_textbook_predict_own(const schuler_f32_local_level_textbook *state,
                                                     schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_local_level_textbook_integrated(const schuler_f32_local_level_textbook *state,
                                                    uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_local_level_textbook_digest(const schuler_f32_local_level_textbook *state,
                                                schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_local_level_textbook_digest_end(const schuler_f32_local_level_textbook *state,
                                                    schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_start(schuler_f32_earth_fixed_h0b4a0 *state,
                                             uint32_t abi,
                                             double rate_hz,
                                             uint32_t order,
                                             const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_earth_fixed_h0b4a0_start_own(schuler_f32_earth_fixed_h0b4a0 *state,
                                                 uint32_t abi,
                                                 const schuler_pair_f32 *interval_s,
                                                 uint32_t order,
                                                 const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_EARTH_FIXED_H0B4A0_SAVED of them, to the front of `length`. Fails with SCHULER_ERROR_SPACE,
 * and as _finish does; nothing is written then. */
int32_t schuler_f32_earth_fixed_h0b4a0_save(const schuler_f32_earth_fixed_h0b4a0 *state,
                                            uint8_t *bytes,
                                            size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_restore(schuler_f32_earth_fixed_h0b4a0 *state,
                                               uint32_t abi,
                                               const uint8_t *stored,
                                               size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_earth_fixed_h0b4a0_forget(schuler_f32_earth_fixed_h0b4a0 *state);

/** Bytes that the library needs of a schuler_f32_earth_fixed_h0b4a0: at most its size. */
size_t schuler_f32_earth_fixed_h0b4a0_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_push(schuler_f32_earth_fixed_h0b4a0 *state,
                                            const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_earth_fixed_h0b4a0_push_rates(schuler_f32_earth_fixed_h0b4a0 *state,
                                                  const schuler_rates_f32 *at_start,
                                                  const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_earth_fixed_h0b4a0_finish(schuler_f32_earth_fixed_h0b4a0 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_correct(schuler_f32_earth_fixed_h0b4a0 *state,
                                               const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_hold_vertical(schuler_f32_earth_fixed_h0b4a0 *state,
                                                     float altitude_m,
                                                     float down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_read(const schuler_f32_earth_fixed_h0b4a0 *state,
                                            schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_earth_fixed_h0b4a0_read_own(const schuler_f32_earth_fixed_h0b4a0 *state,
                                                schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_predict(const schuler_f32_earth_fixed_h0b4a0 *state,
                                               schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_earth_fixed_h0b4a0_predict_own(const schuler_f32_earth_fixed_h0b4a0 *state,
                                                   schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_earth_fixed_h0b4a0_integrated(const schuler_f32_earth_fixed_h0b4a0 *state,
                                                  uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_earth_fixed_h0b4a0_digest(const schuler_f32_earth_fixed_h0b4a0 *state,
                                              schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_earth_fixed_h0b4a0_digest_end(const schuler_f32_earth_fixed_h0b4a0 *state,
                                                  schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_start(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                 uint32_t abi,
                                                 double rate_hz,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_start_own(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                     uint32_t abi,
                                                     const schuler_pair_f32 *interval_s,
                                                     uint32_t order,
                                                     const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_EARTH_FIXED_H0B4A0_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_save(const schuler_f32_earth_fixed_h0b4a0_any *state,
                                                uint8_t *bytes,
                                                size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_restore(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                   uint32_t abi,
                                                   const uint8_t *stored,
                                                   size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_forget(schuler_f32_earth_fixed_h0b4a0_any *state);

/** Bytes that the library needs of a schuler_f32_earth_fixed_h0b4a0_any: at most its size. */
size_t schuler_f32_earth_fixed_h0b4a0_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_push(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_push_rates(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                      const schuler_rates_f32 *at_start,
                                                      const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_finish(schuler_f32_earth_fixed_h0b4a0_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_correct(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                   const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_hold_vertical(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                         float altitude_m,
                                                         float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_push_over(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                     const schuler_increment_f32 *sample,
                                                     const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_push_rates_over(schuler_f32_earth_fixed_h0b4a0_any *state,
                                                           const schuler_rates_f32 *at_start,
                                                           const schuler_rates_f32 *at_end,
                                                           const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_read(const schuler_f32_earth_fixed_h0b4a0_any *state,
                                                schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_read_own(const schuler_f32_earth_fixed_h0b4a0_any *state,
                                                    schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_predict(const schuler_f32_earth_fixed_h0b4a0_any *state,
                                                   schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_predict_own(const schuler_f32_earth_fixed_h0b4a0_any *state,
                                                       schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_integrated(const schuler_f32_earth_fixed_h0b4a0_any *state,
                                                      uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_digest(const schuler_f32_earth_fixed_h0b4a0_any *state,
                                                  schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_earth_fixed_h0b4a0_any_digest_end(const schuler_f32_earth_fixed_h0b4a0_any *state,
                                                      schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_start(schuler_f32_earth_fixed_h2b4a2 *state,
                                             uint32_t abi,
                                             double rate_hz,
                                             uint32_t order,
                                             const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_earth_fixed_h2b4a2_start_own(schuler_f32_earth_fixed_h2b4a2 *state,
                                                 uint32_t abi,
                                                 const schuler_pair_f32 *interval_s,
                                                 uint32_t order,
                                                 const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_EARTH_FIXED_H2B4A2_SAVED of them, to the front of `length`. Fails with SCHULER_ERROR_SPACE,
 * and as _finish does; nothing is written then. */
int32_t schuler_f32_earth_fixed_h2b4a2_save(const schuler_f32_earth_fixed_h2b4a2 *state,
                                            uint8_t *bytes,
                                            size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_restore(schuler_f32_earth_fixed_h2b4a2 *state,
                                               uint32_t abi,
                                               const uint8_t *stored,
                                               size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_earth_fixed_h2b4a2_forget(schuler_f32_earth_fixed_h2b4a2 *state);

/** Bytes that the library needs of a schuler_f32_earth_fixed_h2b4a2: at most its size. */
size_t schuler_f32_earth_fixed_h2b4a2_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_push(schuler_f32_earth_fixed_h2b4a2 *state,
                                            const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_earth_fixed_h2b4a2_push_rates(schuler_f32_earth_fixed_h2b4a2 *state,
                                                  const schuler_rates_f32 *at_start,
                                                  const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_earth_fixed_h2b4a2_finish(schuler_f32_earth_fixed_h2b4a2 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_correct(schuler_f32_earth_fixed_h2b4a2 *state,
                                               const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_hold_vertical(schuler_f32_earth_fixed_h2b4a2 *state,
                                                     float altitude_m,
                                                     float down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_read(const schuler_f32_earth_fixed_h2b4a2 *state,
                                            schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_earth_fixed_h2b4a2_read_own(const schuler_f32_earth_fixed_h2b4a2 *state,
                                                schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_predict(const schuler_f32_earth_fixed_h2b4a2 *state,
                                               schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_earth_fixed_h2b4a2_predict_own(const schuler_f32_earth_fixed_h2b4a2 *state,
                                                   schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_earth_fixed_h2b4a2_integrated(const schuler_f32_earth_fixed_h2b4a2 *state,
                                                  uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_earth_fixed_h2b4a2_digest(const schuler_f32_earth_fixed_h2b4a2 *state,
                                              schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_earth_fixed_h2b4a2_digest_end(const schuler_f32_earth_fixed_h2b4a2 *state,
                                                  schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_start(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                 uint32_t abi,
                                                 double rate_hz,
                                                 uint32_t order,
                                                 const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_start_own(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                     uint32_t abi,
                                                     const schuler_pair_f32 *interval_s,
                                                     uint32_t order,
                                                     const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_EARTH_FIXED_H2B4A2_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_save(const schuler_f32_earth_fixed_h2b4a2_any *state,
                                                uint8_t *bytes,
                                                size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_restore(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                   uint32_t abi,
                                                   const uint8_t *stored,
                                                   size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_forget(schuler_f32_earth_fixed_h2b4a2_any *state);

/** Bytes that the library needs of a schuler_f32_earth_fixed_h2b4a2_any: at most its size. */
size_t schuler_f32_earth_fixed_h2b4a2_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_push(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_push_rates(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                      const schuler_rates_f32 *at_start,
                                                      const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_finish(schuler_f32_earth_fixed_h2b4a2_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_correct(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                   const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_hold_vertical(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                         float altitude_m,
                                                         float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_push_over(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                     const schuler_increment_f32 *sample,
                                                     const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_push_rates_over(schuler_f32_earth_fixed_h2b4a2_any *state,
                                                           const schuler_rates_f32 *at_start,
                                                           const schuler_rates_f32 *at_end,
                                                           const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_read(const schuler_f32_earth_fixed_h2b4a2_any *state,
                                                schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_read_own(const schuler_f32_earth_fixed_h2b4a2_any *state,
                                                    schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_predict(const schuler_f32_earth_fixed_h2b4a2_any *state,
                                                   schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_predict_own(const schuler_f32_earth_fixed_h2b4a2_any *state,
                                                       schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_integrated(const schuler_f32_earth_fixed_h2b4a2_any *state,
                                                      uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_digest(const schuler_f32_earth_fixed_h2b4a2_any *state,
                                                  schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_earth_fixed_h2b4a2_any_digest_end(const schuler_f32_earth_fixed_h2b4a2_any *state,
                                                      schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32_earth_fixed_textbook_start(schuler_f32_earth_fixed_textbook *state,
                                               uint32_t abi,
                                               double rate_hz,
                                               uint32_t order,
                                               const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32_earth_fixed_textbook_start_own(schuler_f32_earth_fixed_textbook *state,
                                                   uint32_t abi,
                                                   const schuler_pair_f32 *interval_s,
                                                   uint32_t order,
                                                   const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32_EARTH_FIXED_TEXTBOOK_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32_earth_fixed_textbook_save(const schuler_f32_earth_fixed_textbook *state,
                                              uint8_t *bytes,
                                              size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32_earth_fixed_textbook_restore(schuler_f32_earth_fixed_textbook *state,
                                                 uint32_t abi,
                                                 const uint8_t *stored,
                                                 size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32_earth_fixed_textbook_forget(schuler_f32_earth_fixed_textbook *state);

/** Bytes that the library needs of a schuler_f32_earth_fixed_textbook: at most its size. */
size_t schuler_f32_earth_fixed_textbook_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32_earth_fixed_textbook_push(schuler_f32_earth_fixed_textbook *state,
                                              const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32_earth_fixed_textbook_push_rates(schuler_f32_earth_fixed_textbook *state,
                                                    const schuler_rates_f32 *at_start,
                                                    const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32_earth_fixed_textbook_finish(schuler_f32_earth_fixed_textbook *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_textbook_correct(schuler_f32_earth_fixed_textbook *state,
                                                 const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32_earth_fixed_textbook_hold_vertical(schuler_f32_earth_fixed_textbook *state,
                                                       float altitude_m,
                                                       float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32_earth_fixed_textbook_push_over(schuler_f32_earth_fixed_textbook *state,
                                                   const schuler_increment_f32 *sample,
                                                   const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32_earth_fixed_textbook_push_rates_over(schuler_f32_earth_fixed_textbook *state,
                                                         const schuler_rates_f32 *at_start,
                                                         const schuler_rates_f32 *at_end,
                                                         const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_textbook_read(const schuler_f32_earth_fixed_textbook *state,
                                              schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32_earth_fixed_textbook_read_own(const schuler_f32_earth_fixed_textbook *state,
                                                  schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32_earth_fixed_textbook_predict(const schuler_f32_earth_fixed_textbook *state,
                                                 schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32_earth_fixed_textbook_predict_own(const schuler_f32_earth_fixed_textbook *state,
                                                     schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32_earth_fixed_textbook_integrated(const schuler_f32_earth_fixed_textbook *state,
                                                    uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32_earth_fixed_textbook_digest(const schuler_f32_earth_fixed_textbook *state,
                                                schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32_earth_fixed_textbook_digest_end(const schuler_f32_earth_fixed_textbook *state,
                                                    schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_start(schuler_f32x2_local_level_h0b4a0 *state,
                                               uint32_t abi,
                                               double rate_hz,
                                               uint32_t order,
                                               const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32x2_local_level_h0b4a0_start_own(schuler_f32x2_local_level_h0b4a0 *state,
                                                   uint32_t abi,
                                                   const schuler_pair_f32 *interval_s,
                                                   uint32_t order,
                                                   const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32X2_LOCAL_LEVEL_H0B4A0_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32x2_local_level_h0b4a0_save(const schuler_f32x2_local_level_h0b4a0 *state,
                                              uint8_t *bytes,
                                              size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_restore(schuler_f32x2_local_level_h0b4a0 *state,
                                                 uint32_t abi,
                                                 const uint8_t *stored,
                                                 size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32x2_local_level_h0b4a0_forget(schuler_f32x2_local_level_h0b4a0 *state);

/** Bytes that the library needs of a schuler_f32x2_local_level_h0b4a0: at most its size. */
size_t schuler_f32x2_local_level_h0b4a0_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_push(schuler_f32x2_local_level_h0b4a0 *state,
                                              const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32x2_local_level_h0b4a0_push_rates(schuler_f32x2_local_level_h0b4a0 *state,
                                                    const schuler_rates_f32 *at_start,
                                                    const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32x2_local_level_h0b4a0_finish(schuler_f32x2_local_level_h0b4a0 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_correct(schuler_f32x2_local_level_h0b4a0 *state,
                                                 const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_hold_vertical(schuler_f32x2_local_level_h0b4a0 *state,
                                                       float altitude_m,
                                                       float down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_read(const schuler_f32x2_local_level_h0b4a0 *state,
                                              schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32x2_local_level_h0b4a0_read_own(const schuler_f32x2_local_level_h0b4a0 *state,
                                                  schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_predict(const schuler_f32x2_local_level_h0b4a0 *state,
                                                 schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32x2_local_level_h0b4a0_predict_own(const schuler_f32x2_local_level_h0b4a0 *state,
                                                     schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32x2_local_level_h0b4a0_integrated(const schuler_f32x2_local_level_h0b4a0 *state,
                                                    uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32x2_local_level_h0b4a0_digest(const schuler_f32x2_local_level_h0b4a0 *state,
                                                schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32x2_local_level_h0b4a0_digest_end(const schuler_f32x2_local_level_h0b4a0 *state,
                                                    schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_start(schuler_f32x2_local_level_h0b4a0_any *state,
                                                   uint32_t abi,
                                                   double rate_hz,
                                                   uint32_t order,
                                                   const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32x2_local_level_h0b4a0_any_start_own(schuler_f32x2_local_level_h0b4a0_any *state,
                                                       uint32_t abi,
                                                       const schuler_pair_f32 *interval_s,
                                                       uint32_t order,
                                                       const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32X2_LOCAL_LEVEL_H0B4A0_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_save(const schuler_f32x2_local_level_h0b4a0_any *state,
                                                  uint8_t *bytes,
                                                  size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_restore(schuler_f32x2_local_level_h0b4a0_any *state,
                                                     uint32_t abi,
                                                     const uint8_t *stored,
                                                     size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32x2_local_level_h0b4a0_any_forget(schuler_f32x2_local_level_h0b4a0_any *state);

/** Bytes that the library needs of a schuler_f32x2_local_level_h0b4a0_any: at most its size. */
size_t schuler_f32x2_local_level_h0b4a0_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_push(schuler_f32x2_local_level_h0b4a0_any *state,
                                                  const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32x2_local_level_h0b4a0_any_push_rates(schuler_f32x2_local_level_h0b4a0_any *state,
                                                        const schuler_rates_f32 *at_start,
                                                        const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32x2_local_level_h0b4a0_any_finish(schuler_f32x2_local_level_h0b4a0_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_correct(schuler_f32x2_local_level_h0b4a0_any *state,
                                                     const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_hold_vertical(schuler_f32x2_local_level_h0b4a0_any *state,
                                                           float altitude_m,
                                                           float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32x2_local_level_h0b4a0_any_push_over(schuler_f32x2_local_level_h0b4a0_any *state,
                                                       const schuler_increment_f32 *sample,
                                                       const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32x2_local_level_h0b4a0_any_push_rates_over(schuler_f32x2_local_level_h0b4a0_any *state,
                                                             const schuler_rates_f32 *at_start,
                                                             const schuler_rates_f32 *at_end,
                                                             const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_read(const schuler_f32x2_local_level_h0b4a0_any *state,
                                                  schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32x2_local_level_h0b4a0_any_read_own(const schuler_f32x2_local_level_h0b4a0_any *state,
                                                      schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_predict(const schuler_f32x2_local_level_h0b4a0_any *state,
                                                     schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32x2_local_level_h0b4a0_any_predict_own(const schuler_f32x2_local_level_h0b4a0_any *state,
                                                         schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32x2_local_level_h0b4a0_any_integrated(const schuler_f32x2_local_level_h0b4a0_any *state,
                                                        uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32x2_local_level_h0b4a0_any_digest(const schuler_f32x2_local_level_h0b4a0_any *state,
                                                    schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32x2_local_level_h0b4a0_any_digest_end(const schuler_f32x2_local_level_h0b4a0_any *state,
                                                        schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_start(schuler_f32x2_local_level_h2b4a2 *state,
                                               uint32_t abi,
                                               double rate_hz,
                                               uint32_t order,
                                               const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32x2_local_level_h2b4a2_start_own(schuler_f32x2_local_level_h2b4a2 *state,
                                                   uint32_t abi,
                                                   const schuler_pair_f32 *interval_s,
                                                   uint32_t order,
                                                   const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32X2_LOCAL_LEVEL_H2B4A2_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32x2_local_level_h2b4a2_save(const schuler_f32x2_local_level_h2b4a2 *state,
                                              uint8_t *bytes,
                                              size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_restore(schuler_f32x2_local_level_h2b4a2 *state,
                                                 uint32_t abi,
                                                 const uint8_t *stored,
                                                 size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32x2_local_level_h2b4a2_forget(schuler_f32x2_local_level_h2b4a2 *state);

/** Bytes that the library needs of a schuler_f32x2_local_level_h2b4a2: at most its size. */
size_t schuler_f32x2_local_level_h2b4a2_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_push(schuler_f32x2_local_level_h2b4a2 *state,
                                              const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32x2_local_level_h2b4a2_push_rates(schuler_f32x2_local_level_h2b4a2 *state,
                                                    const schuler_rates_f32 *at_start,
                                                    const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32x2_local_level_h2b4a2_finish(schuler_f32x2_local_level_h2b4a2 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_correct(schuler_f32x2_local_level_h2b4a2 *state,
                                                 const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_hold_vertical(schuler_f32x2_local_level_h2b4a2 *state,
                                                       float altitude_m,
                                                       float down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_read(const schuler_f32x2_local_level_h2b4a2 *state,
                                              schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32x2_local_level_h2b4a2_read_own(const schuler_f32x2_local_level_h2b4a2 *state,
                                                  schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_predict(const schuler_f32x2_local_level_h2b4a2 *state,
                                                 schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32x2_local_level_h2b4a2_predict_own(const schuler_f32x2_local_level_h2b4a2 *state,
                                                     schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32x2_local_level_h2b4a2_integrated(const schuler_f32x2_local_level_h2b4a2 *state,
                                                    uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32x2_local_level_h2b4a2_digest(const schuler_f32x2_local_level_h2b4a2 *state,
                                                schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32x2_local_level_h2b4a2_digest_end(const schuler_f32x2_local_level_h2b4a2 *state,
                                                    schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_start(schuler_f32x2_local_level_h2b4a2_any *state,
                                                   uint32_t abi,
                                                   double rate_hz,
                                                   uint32_t order,
                                                   const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32x2_local_level_h2b4a2_any_start_own(schuler_f32x2_local_level_h2b4a2_any *state,
                                                       uint32_t abi,
                                                       const schuler_pair_f32 *interval_s,
                                                       uint32_t order,
                                                       const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32X2_LOCAL_LEVEL_H2B4A2_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_save(const schuler_f32x2_local_level_h2b4a2_any *state,
                                                  uint8_t *bytes,
                                                  size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_restore(schuler_f32x2_local_level_h2b4a2_any *state,
                                                     uint32_t abi,
                                                     const uint8_t *stored,
                                                     size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32x2_local_level_h2b4a2_any_forget(schuler_f32x2_local_level_h2b4a2_any *state);

/** Bytes that the library needs of a schuler_f32x2_local_level_h2b4a2_any: at most its size. */
size_t schuler_f32x2_local_level_h2b4a2_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_push(schuler_f32x2_local_level_h2b4a2_any *state,
                                                  const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32x2_local_level_h2b4a2_any_push_rates(schuler_f32x2_local_level_h2b4a2_any *state,
                                                        const schuler_rates_f32 *at_start,
                                                        const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32x2_local_level_h2b4a2_any_finish(schuler_f32x2_local_level_h2b4a2_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_correct(schuler_f32x2_local_level_h2b4a2_any *state,
                                                     const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_hold_vertical(schuler_f32x2_local_level_h2b4a2_any *state,
                                                           float altitude_m,
                                                           float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32x2_local_level_h2b4a2_any_push_over(schuler_f32x2_local_level_h2b4a2_any *state,
                                                       const schuler_increment_f32 *sample,
                                                       const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32x2_local_level_h2b4a2_any_push_rates_over(schuler_f32x2_local_level_h2b4a2_any *state,
                                                             const schuler_rates_f32 *at_start,
                                                             const schuler_rates_f32 *at_end,
                                                             const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_read(const schuler_f32x2_local_level_h2b4a2_any *state,
                                                  schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32x2_local_level_h2b4a2_any_read_own(const schuler_f32x2_local_level_h2b4a2_any *state,
                                                      schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_predict(const schuler_f32x2_local_level_h2b4a2_any *state,
                                                     schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32x2_local_level_h2b4a2_any_predict_own(const schuler_f32x2_local_level_h2b4a2_any *state,
                                                         schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32x2_local_level_h2b4a2_any_integrated(const schuler_f32x2_local_level_h2b4a2_any *state,
                                                        uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32x2_local_level_h2b4a2_any_digest(const schuler_f32x2_local_level_h2b4a2_any *state,
                                                    schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32x2_local_level_h2b4a2_any_digest_end(const schuler_f32x2_local_level_h2b4a2_any *state,
                                                        schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_start(schuler_f32x2_earth_fixed_h0b4a0 *state,
                                               uint32_t abi,
                                               double rate_hz,
                                               uint32_t order,
                                               const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_start_own(schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                   uint32_t abi,
                                                   const schuler_pair_f32 *interval_s,
                                                   uint32_t order,
                                                   const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32X2_EARTH_FIXED_H0B4A0_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_save(const schuler_f32x2_earth_fixed_h0b4a0 *state,
                                              uint8_t *bytes,
                                              size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_restore(schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                 uint32_t abi,
                                                 const uint8_t *stored,
                                                 size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_forget(schuler_f32x2_earth_fixed_h0b4a0 *state);

/** Bytes that the library needs of a schuler_f32x2_earth_fixed_h0b4a0: at most its size. */
size_t schuler_f32x2_earth_fixed_h0b4a0_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_push(schuler_f32x2_earth_fixed_h0b4a0 *state,
                                              const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_push_rates(schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                    const schuler_rates_f32 *at_start,
                                                    const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_finish(schuler_f32x2_earth_fixed_h0b4a0 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_correct(schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                 const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_hold_vertical(schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                       float altitude_m,
                                                       float down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_read(const schuler_f32x2_earth_fixed_h0b4a0 *state,
                                              schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_read_own(const schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                  schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_predict(const schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                 schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_predict_own(const schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                     schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_integrated(const schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                    uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_digest(const schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_digest_end(const schuler_f32x2_earth_fixed_h0b4a0 *state,
                                                    schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_start(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                   uint32_t abi,
                                                   double rate_hz,
                                                   uint32_t order,
                                                   const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_start_own(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                       uint32_t abi,
                                                       const schuler_pair_f32 *interval_s,
                                                       uint32_t order,
                                                       const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32X2_EARTH_FIXED_H0B4A0_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_save(const schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                  uint8_t *bytes,
                                                  size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_restore(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                     uint32_t abi,
                                                     const uint8_t *stored,
                                                     size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_forget(schuler_f32x2_earth_fixed_h0b4a0_any *state);

/** Bytes that the library needs of a schuler_f32x2_earth_fixed_h0b4a0_any: at most its size. */
size_t schuler_f32x2_earth_fixed_h0b4a0_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_push(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                  const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_push_rates(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                        const schuler_rates_f32 *at_start,
                                                        const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_finish(schuler_f32x2_earth_fixed_h0b4a0_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_correct(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                     const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_hold_vertical(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                           float altitude_m,
                                                           float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_push_over(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                       const schuler_increment_f32 *sample,
                                                       const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_push_rates_over(schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                             const schuler_rates_f32 *at_start,
                                                             const schuler_rates_f32 *at_end,
                                                             const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_read(const schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                  schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_read_own(const schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                      schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_predict(const schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                     schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_predict_own(const schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                         schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_integrated(const schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                        uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_digest(const schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                    schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32x2_earth_fixed_h0b4a0_any_digest_end(const schuler_f32x2_earth_fixed_h0b4a0_any *state,
                                                        schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_start(schuler_f32x2_earth_fixed_h2b4a2 *state,
                                               uint32_t abi,
                                               double rate_hz,
                                               uint32_t order,
                                               const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_start_own(schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                   uint32_t abi,
                                                   const schuler_pair_f32 *interval_s,
                                                   uint32_t order,
                                                   const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32X2_EARTH_FIXED_H2B4A2_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_save(const schuler_f32x2_earth_fixed_h2b4a2 *state,
                                              uint8_t *bytes,
                                              size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_restore(schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                 uint32_t abi,
                                                 const uint8_t *stored,
                                                 size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_forget(schuler_f32x2_earth_fixed_h2b4a2 *state);

/** Bytes that the library needs of a schuler_f32x2_earth_fixed_h2b4a2: at most its size. */
size_t schuler_f32x2_earth_fixed_h2b4a2_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_push(schuler_f32x2_earth_fixed_h2b4a2 *state,
                                              const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_push_rates(schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                    const schuler_rates_f32 *at_start,
                                                    const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_finish(schuler_f32x2_earth_fixed_h2b4a2 *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_correct(schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                 const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_hold_vertical(schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                       float altitude_m,
                                                       float down_m_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_read(const schuler_f32x2_earth_fixed_h2b4a2 *state,
                                              schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_read_own(const schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                  schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_predict(const schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                 schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_predict_own(const schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                     schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_integrated(const schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                    uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_digest(const schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_digest_end(const schuler_f32x2_earth_fixed_h2b4a2 *state,
                                                    schuler_digest *digest);

/** Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes.
 * `abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a
 * motion needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI,
 * _INTERVAL, _POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_start(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                   uint32_t abi,
                                                   double rate_hz,
                                                   uint32_t order,
                                                   const schuler_solution_f64 *initial);

/** The same in the navigator's own precision, with nothing in double precision where that is single:
 * `interval_s` is the interval from sample to sample, s, at most 1 s, with its rest. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_start_own(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                       uint32_t abi,
                                                       const schuler_pair_f32 *interval_s,
                                                       uint32_t order,
                                                       const schuler_solution_f32 *initial);

/** Writes the state as bytes that any target can restore, with a check:
 * SCHULER_F32X2_EARTH_FIXED_H2B4A2_ANY_SAVED of them, to the front of `length`. Fails with
 * SCHULER_ERROR_SPACE, and as _finish does; nothing is written then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_save(const schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                  uint8_t *bytes,
                                                  size_t length);

/** Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started.
 * Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI,
 * _NULL or _MISALIGNED; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_restore(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                     uint32_t abi,
                                                     const uint8_t *stored,
                                                     size_t length);

/** Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails
 * as _finish does. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_forget(schuler_f32x2_earth_fixed_h2b4a2_any *state);

/** Bytes that the library needs of a schuler_f32x2_earth_fixed_h2b4a2_any: at most its size. */
size_t schuler_f32x2_earth_fixed_h2b4a2_any_size(void);

/** Takes a sample: increments over the interval that the navigator was started with. The state moves on
 * whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE,
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_push(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                  const schuler_increment_f32 *sample);

/** The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by
 * the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_push_rates(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                        const schuler_rates_f32 *at_start,
                                                        const schuler_rates_f32 *at_end);

/** Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with
 * SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_finish(schuler_f32x2_earth_fixed_h2b4a2_any *state);

/** Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE,
 * _POLE, _PLACE or _STATE, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_correct(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                     const schuler_correction_f32 *correction);

/** Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down
 * positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_hold_vertical(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                           float altitude_m,
                                                           float down_m_s);

/** Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the
 * interval of the start it leaves the bits of _push. Fails as _push does, and with
 * SCHULER_REJECTED_INTERVAL. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_push_over(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                       const schuler_increment_f32 *sample,
                                                       const schuler_pair_f32 *interval_s);

/** The same for rates at the sample's start and end. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_push_rates_over(schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                             const schuler_rates_f32 *at_start,
                                                             const schuler_rates_f32 *at_end,
                                                             const schuler_pair_f32 *interval_s);

/** The solution at the end of the last block, in local axes and in double precision, from all digits that
 * the navigator carries. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_read(const schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                  schuler_solution_f64 *solution);

/** The same in the navigator's own precision and axes: every bit of its output, and the least work. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_read_own(const schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                      schuler_solution_f32 *solution);

/** The solution at the newest sample, without the delay of a block, as _read has it. The state does not
 * change. Fails as _finish does; `solution` is as it was then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_predict(const schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                     schuler_solution_f64 *solution);

/** The same as _read_own has it. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_predict_own(const schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                         schuler_solution_f32 *solution);

/** How many samples lie behind the solution that _read gives. Fails as _finish does. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_integrated(const schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                        uint64_t *samples);

/** Adds the state to a running digest if a block has been completed since the last time: call it after
 * every sample, then _finish and _digest_end. For the same samples the digest is the same on every target,
 * and that of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_digest(const schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                    schuler_digest *digest);

/** The same at the end of the stream, after _finish: the last state is added in any case. */
int32_t schuler_f32x2_earth_fixed_h2b4a2_any_digest_end(const schuler_f32x2_earth_fixed_h2b4a2_any *state,
                                                        schuler_digest *digest);

/** The name of a result, such as "SCHULER_ERROR_NULL": a constant text, never null. */
const char *schuler_result_name(int32_t result);

/** What a result means, in English and UTF-8: a constant text, never null. */
const char *schuler_result_text(int32_t result);

/** Switches a target on; `boot` is how often it was before, or another number that differs every time, and
 * `abi` SCHULER_ABI. Then say _hello. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI. */
int32_t schuler_target_start(schuler_target *target,
                             uint32_t abi,
                             uint32_t boot);

/** Announces the target: the first frame that it sends, through `send`. Fails with SCHULER_ERROR_NULL,
 * _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_target_hello(schuler_target *target,
                             schuler_send send,
                             void *context);

/** Takes a byte from the line. A frame that it completes is answered through `send`, which gets all bytes
 * of the answer at once. Fails as _hello does; nothing changes then. */
int32_t schuler_target_take(schuler_target *target,
                            uint8_t byte,
                            schuler_send send,
                            void *context);

/** How many samples the target has taken; 0 before the host has started a flight. Fails as _hello does. */
int32_t schuler_target_taken(const schuler_target *target,
                             uint32_t *samples);

/** Switches a target on; `boot` is how often it was before, or another number that differs every time, and
 * `abi` SCHULER_ABI. Then say _hello. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI. */
int32_t schuler_target_f32_start(schuler_target_f32 *target,
                                 uint32_t abi,
                                 uint32_t boot);

/** Announces the target: the first frame that it sends, through `send`. Fails with SCHULER_ERROR_NULL,
 * _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE. */
int32_t schuler_target_f32_hello(schuler_target_f32 *target,
                                 schuler_send send,
                                 void *context);

/** Takes a byte from the line. A frame that it completes is answered through `send`, which gets all bytes
 * of the answer at once. Fails as _hello does; nothing changes then. */
int32_t schuler_target_f32_take(schuler_target_f32 *target,
                                uint8_t byte,
                                schuler_send send,
                                void *context);

/** How many samples the target has taken; 0 before the host has started a flight. Fails as _hello does. */
int32_t schuler_target_f32_taken(const schuler_target_f32 *target,
                                 uint32_t *samples);

/** A solution from plain numbers: latitude, longitude (rad) and height (m), velocity north, east, down
 * (m/s), and roll, pitch, yaw (rad, at most 2 pi: yaw about down from north, then pitch about right, then
 * roll about forward). Fails with SCHULER_ERROR_NULL or _MISALIGNED. */
int32_t schuler_solution_f32_from(float latitude_rad,
                                  float longitude_rad,
                                  float altitude_m,
                                  const schuler_vector_f32 *velocity_ned_m_s,
                                  const schuler_vector_f32 *roll_pitch_yaw_rad,
                                  schuler_solution_f32 *solution);

/** Roll, pitch and yaw of a solution in local axes, rad, to the digits of f32: yaw within 180 degrees,
 * pitch within 90. Fails with SCHULER_ERROR_NULL or _MISALIGNED. */
int32_t schuler_solution_f32_euler(const schuler_solution_f32 *solution,
                                   schuler_vector_f32 *roll_pitch_yaw_rad);

/** A solution from plain numbers: latitude, longitude (rad) and height (m), velocity north, east, down
 * (m/s), and roll, pitch, yaw (rad, at most 2 pi: yaw about down from north, then pitch about right, then
 * roll about forward). Fails with SCHULER_ERROR_NULL or _MISALIGNED. */
int32_t schuler_solution_f64_from(double latitude_rad,
                                  double longitude_rad,
                                  double altitude_m,
                                  const schuler_vector_f64 *velocity_ned_m_s,
                                  const schuler_vector_f64 *roll_pitch_yaw_rad,
                                  schuler_solution_f64 *solution);

/** Roll, pitch and yaw of a solution in local axes, rad, to the digits of f64: yaw within 180 degrees,
 * pitch within 90. Fails with SCHULER_ERROR_NULL or _MISALIGNED. */
int32_t schuler_solution_f64_euler(const schuler_solution_f64 *solution,
                                   schuler_vector_f64 *roll_pitch_yaw_rad);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SCHULER_H */
