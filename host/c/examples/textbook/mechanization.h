/* The textbook's mechanization in local-level axes and double precision, written by hand. */

#ifndef MECHANIZATION_H
#define MECHANIZATION_H

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

/* Principal radii of curvature, m. */
typedef struct {
    double meridian, prime_vertical;
} radii;

vector of(double x, double y, double z);
radii radii_at(double sine);
double gravity(double sine, double altitude);
motion compensated(const increment *now, const increment *before);
void step(state *at, const motion *body, double h);

#endif
