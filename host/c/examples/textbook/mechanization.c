/* The step of the textbook: coning and sculling by the sample before, then velocity, position and attitude.
 *
 * Sources: Savage, J. Guidance 21 (1998); Groves, 2nd ed., section 5.5; WGS-84, NIMA TR8350.2. */

#include "mechanization.h"

#include <math.h>

static const double a = 6378137.0;
static const double f = 1.0 / 298.257223563;
static const double rotation_rate = 7.292115e-5;

vector of(double x, double y, double z)
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
motion compensated(const increment *now, const increment *before)
{
    vector angle = now->angle, velocity = now->velocity;
    double square = dot(angle, angle);
    double first = 0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0));
    double second = 1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0));
    vector swept = cross(angle, velocity);
    vector sculling = plus(cross(before->angle, velocity), cross(before->velocity, angle));
    motion body;

#ifdef PLANTED
    body.rotation = rotation(plus(angle, times(cross(angle, before->angle), 1.0 / 12.0)));
#else
    body.rotation = rotation(plus(angle, times(cross(before->angle, angle), 1.0 / 12.0)));
#endif
    body.velocity = plus(plus(plus(velocity, times(swept, first)), times(cross(angle, swept), second)),
                         times(sculling, 1.0 / 12.0));
    return body;
}

/* Somigliana's gravity with the second order in height, m/s^2, by the sine of the latitude. */
double gravity(double sine, double altitude)
{
    double e2 = f * (2.0 - f), s2 = sine * sine;
    double of_height = altitude * (-2.0 / a * (1.0 + f + 0.00344978650684) + 4.0 * f / a * s2 + 3.0 / (a * a) * altitude);

    return 9.7803253359 * (1.0 + 0.00193185265241 * s2) / sqrt(1.0 - e2 * s2) * (1.0 + of_height);
}

/* Radii at a latitude, by its sine. */
radii radii_at(double sine)
{
    double e2 = f * (2.0 - f), w2 = 1.0 - e2 * sine * sine;
    radii r;

    r.prime_vertical = a / sqrt(w2);
    r.meridian = r.prime_vertical * (1.0 - e2) / w2;
    return r;
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

void step(state *at, const motion *body, double h)
{
    /* At the middle of the step, extrapolated by the change over the last one. */
    vector v = plus(at->velocity, times(at->velocity_change, 0.5));
    double s = at->sine, c = at->cosine, altitude = at->altitude + at->altitude_change * 0.5;
    double east_radius, north_radius, eastward;
    vector earth, transport, frame, turn, gained, pull, change, mean;
    quaternion q;
    radii at_middle;
    double k;

    advance(&s, &c, at->latitude_change * 0.5);
    at_middle = radii_at(s);
    north_radius = at_middle.meridian + altitude;
    east_radius = at_middle.prime_vertical + altitude;
    earth = of(rotation_rate * c, 0.0, -(rotation_rate * s));
    eastward = v.y / east_radius;
    transport = of(eastward, -(v.x / north_radius), -(eastward * s / c));
    frame = plus(earth, transport);
    turn = times(frame, h);

    gained = turned_by(at->attitude, body->velocity);
    pull = times(cross(plus(frame, earth), v), -1.0);
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
