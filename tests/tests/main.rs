//! Every integration test of the workspace, in one program: it is linked once.
//!
//! | module | what |
//! |---|---|
//! | `aiding` | the covariance core and fine alignment |
//! | `foundation` | arithmetic, the Earth, motion, the perfect unit, alignment |
//! | `functions` | libm's bits |
//! | `ulps` | every kernel against high precision |
//! | `segments` | paths by manoeuvres |
//! | `sensor_…` | error terms, their noise and their parameters |
//! | `strapdown` | mechanizations, their windows and their states |
//! | `steps`, `plan`, `runge_kutta` | what steps leave out, what the plan chooses, the yardstick |
//! | `drift`, `error_dynamics` | solution less truth, and its linear model |
//! | `theory`, `theory_…`, `ensemble` | what theory expects, and how runs scatter |
//! | `lanes`, `lanes_sensors`, `lanes_truth` | runs abreast, their sensors, samples of a flight side by side |
//! | `paths` | splines, way-points, logs |
//! | `link` | frames, and the application at their end |
//! | `allan` | the Allan variance, and its degrees of freedom |
//! | `catalogue`, `scenes` | navigators by name; the scene that stands in source and in TOML |
//! | `release` | licences and version |
//! | `matrix` | what the matrix of targets refuses |
//! | `figures`, `speed` | the README's figures, and what the benchmarks fly |

mod aiding;
mod allan;
mod catalogue;
mod drift;
mod ensemble;
mod error_dynamics;
mod figures;
mod foundation;
mod functions;
mod lanes;
mod lanes_sensors;
mod lanes_truth;
mod link;
mod matrix;
mod paths;
mod plan;
mod release;
mod runge_kutta;
mod scenes;
mod segments;
mod sensor_allan;
mod sensor_emulator;
mod sensor_gauss_markov;
mod sensor_models;
mod sensor_noise;
mod sensor_parameters;
mod sensor_response;
mod speed;
mod steps;
mod strapdown;
mod theory;
mod theory_motion;
mod theory_response;
mod theory_sources;
mod ulps;
