/* A port of the textbook's mechanization, written by hand in C99: local-level axes, double precision. It does not use the
 * library. It shows how a port is audited: it flies the samples of a golden flight and writes what it holds after every
 * sample as a chain, which `schuler audit compare` holds against the golden one.
 *
 *     textbook noise.chain f64-local-level-textbook.chain > mine.chain
 *     schuler audit compare f64-local-level-textbook.chain mine.chain
 *
 * Compiled with -DPLANTED it has a fault: the Earth's rate counts once in the Coriolis term, where it has to count twice.
 * Compile it with -ffp-contract=off: a fused multiplication and addition rounds once where the others round twice.
 *
 * Sources: Savage, J. Guidance 21 (1998); Groves, 2nd ed., section 5.5; WGS-84, NIMA TR8350.2. */

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    double x, y, z;
} vector;

typedef struct {
    double w;
    vector v;
} quaternion;

/* A sample: integrals over it, rad and m/s. */
typedef struct {
    vector angle, velocity;
} increment;

/* What the navigator holds. Angles in rad; north, east, down; attitude from body to north, east, down. */
typedef struct {
    double latitude, longitude, altitude;
    double sine, cosine;
    vector velocity;
    quaternion attitude;
    vector velocity_change;
    double latitude_change, altitude_change;
} state;

/* The body's motion over a sample. */
typedef struct {
    quaternion rotation;
    vector velocity;
} motion;

static const double a = 6378137.0;
static const double f = 1.0 / 298.257223563;
static const double rotation_rate = 7.292115e-5;

static vector of(double x, double y, double z)
{
    vector v = { x, y, z };
    return v;
}

static vector plus(vector p, vector q)
{
    return of(p.x + q.x, p.y + q.y, p.z + q.z);
}

static vector minus(vector p, vector q)
{
    return of(p.x - q.x, p.y - q.y, p.z - q.z);
}

static vector times(vector p, double k)
{
    return of(p.x * k, p.y * k, p.z * k);
}

static double dot(vector p, vector q)
{
    return p.x * q.x + p.y * q.y + p.z * q.z;
}

static vector cross(vector p, vector q)
{
    return of(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x);
}

static quaternion product(quaternion one, quaternion other)
{
    vector p = one.v, q = other.v;
    quaternion r;

    r.w = one.w * other.w - dot(p, q);
    r.v.x = one.w * q.x + p.x * other.w + p.y * q.z - p.z * q.y;
    r.v.y = one.w * q.y + p.y * other.w + p.z * q.x - p.x * q.z;
    r.v.z = one.w * q.z + p.z * other.w + p.x * q.y - p.y * q.x;
    return r;
}

/* C u for the matrix of a unit quaternion. */
static vector turned_by(quaternion q, vector u)
{
    double x2 = q.v.x + q.v.x, y2 = q.v.y + q.v.y, z2 = q.v.z + q.v.z;
    double xx = q.v.x * x2, yy = q.v.y * y2, zz = q.v.z * z2;
    double xy = q.v.x * y2, xz = q.v.x * z2, yz = q.v.y * z2;
    double wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;

    return of(dot(of(1.0 - (yy + zz), xy - wz, xz + wy), u),
              dot(of(xy + wz, 1.0 - (xx + zz), yz - wx), u),
              dot(of(xz - wy, yz + wx, 1.0 - (xx + yy)), u));
}

/* The unit quaternion of a rotation vector, by its series. */
static quaternion rotation(vector angle)
{
    double x = dot(angle, angle) * 0.25;
    double sinc = 1.0 - x * (1.0 / 6.0 - x * (1.0 / 120.0 - x * (1.0 / 5040.0 - x * (1.0 / 362880.0))));
    quaternion q;

    q.w = 1.0 - x * (0.5 - x * (1.0 / 24.0 - x * (1.0 / 720.0 - x * (1.0 / 40320.0))));
    q.v = times(angle, sinc * 0.5);
    return q;
}

/* Coning, sculling and rotation of a sample, by the one before it. */
static motion compensated(const increment *now, const increment *before)
{
    vector angle = now->angle, velocity = now->velocity;
    double square = dot(angle, angle);
    double first = 0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0));
    double second = 1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0));
    vector swept = cross(angle, velocity);
    vector sculling = plus(cross(before->angle, velocity), cross(before->velocity, angle));
    motion body;

    body.rotation = rotation(plus(angle, times(cross(before->angle, angle), 1.0 / 12.0)));
    body.velocity = plus(plus(plus(velocity, times(swept, first)), times(cross(angle, swept), second)),
                         times(sculling, 1.0 / 12.0));
    return body;
}

/* Somigliana's gravity with the second order in height, m/s^2, by the sine of the latitude. */
static double gravity(double sine, double altitude)
{
    double e2 = f * (2.0 - f), s2 = sine * sine;
    double of_height = altitude * (-2.0 / a * (1.0 + f + 0.00344978650684) + 4.0 * f / a * s2 + 3.0 / (a * a) * altitude);

    return 9.7803253359 * (1.0 + 0.00193185265241 * s2) / sqrt(1.0 - e2 * s2) * (1.0 + of_height);
}

/* Sine and cosine of an angle that has grown by a small one. */
static void advance(double *sine, double *cosine, double angle)
{
    double square = angle * angle, s = *sine, c = *cosine;
    double d = angle - angle * square * (1.0 / 6.0);
    double versine = square * (0.5 - square * (1.0 / 24.0));

    *sine = s + (c * d - s * versine);
    *cosine = c - (s * d + c * versine);
}

static void step(state *at, const motion *body, double h)
{
    /* At the middle of the step, extrapolated by the change over the last one. */
    vector v = plus(at->velocity, times(at->velocity_change, 0.5));
    double s = at->sine, c = at->cosine, altitude = at->altitude + at->altitude_change * 0.5;
    double e2 = f * (2.0 - f), w2, east_radius, north_radius, eastward;
    vector earth, transport, frame, turn, gained, pull, change, mean;
    quaternion q;
    double k;

    advance(&s, &c, at->latitude_change * 0.5);
    w2 = 1.0 - e2 * s * s;
    east_radius = a / sqrt(w2);
    north_radius = east_radius * (1.0 - e2) / w2 + altitude;
    east_radius = east_radius + altitude;
    earth = of(rotation_rate * c, 0.0, -(rotation_rate * s));
    eastward = v.y / east_radius;
    transport = of(eastward, -(v.x / north_radius), -(eastward * s / c));
    frame = plus(earth, transport);
    turn = times(frame, h);

    gained = turned_by(at->attitude, body->velocity);
#ifdef PLANTED
    pull = times(cross(frame, v), -1.0);
#else
    pull = times(cross(plus(frame, earth), v), -1.0);
#endif
    pull.z = pull.z + gravity(s, altitude);
    change = plus(minus(gained, times(cross(turn, gained), 0.5)), times(pull, h));
    mean = plus(at->velocity, times(change, 0.5));
    at->velocity = plus(at->velocity, change);
    at->velocity_change = change;
    at->latitude_change = h * mean.x / north_radius;
    at->altitude_change = -(h * mean.z);
    at->latitude = at->latitude + at->latitude_change;
    at->longitude = at->longitude + h * mean.y / (east_radius * c);
    at->altitude = at->altitude + at->altitude_change;
    if (fabs(at->longitude) > 3.14159265358979323846) {
        at->longitude = at->longitude + ((at->longitude < 0.0) ? 6.28318530717958647693 : -6.28318530717958647693);
    }
    advance(&at->sine, &at->cosine, at->latitude_change);

    q = product(product(rotation(times(turn, -1.0)), at->attitude), body->rotation);
    k = 1.5 - 0.5 * (q.w * q.w + dot(q.v, q.v));
    at->attitude.w = q.w * k;
    at->attitude.v = times(q.v, k);
}

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
