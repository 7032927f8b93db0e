// Flies the files of a folder with the engine of KF-GINS: KF-GINS.csv, and KF-GINS.cost in µs per sample. The engine's
// sources are compiled beside this file; what it prints goes to standard output.
//   fly_kf_gins FOLDER …
#include "kf-gins/gi_engine.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr double degree = M_PI / 180;
// What is constant by the scene: the engine has Gauss-Markov processes alone. It has scale factors, which the scene has not.
constexpr double forever_s = 1e12, no_scale = 1e-12;

std::ifstream opened(const std::string &name) {
    std::ifstream file(name);
    if (!file) { throw std::runtime_error(name + " cannot be opened"); }
    return file;
}

// A file of lines `key = number`.
std::map<std::string, double> flat(const std::string &name) {
    auto file = opened(name);
    std::map<std::string, double> numbers;
    for (std::string line; std::getline(file, line);) {
        const auto equals = line.find(" = ");
        if (equals != std::string::npos) { numbers[line.substr(0, equals)] = std::stod(line.substr(equals + 3)); }
    }
    return numbers;
}

// Named columns of a table, those that are asked for.
std::vector<std::vector<double>> table(const std::string &name, const std::vector<std::string> &columns) {
    auto file = opened(name);
    const auto cells = [](const std::string &line) {
        std::vector<std::string> all;
        std::stringstream rest(line);
        for (std::string cell; std::getline(rest, cell, ',');) { all.push_back(cell); }
        return all;
    };
    std::string line;
    std::getline(file, line);
    const auto header = cells(line);
    std::vector<std::size_t> places;
    for (const auto &column : columns) {
        const auto found = std::find(header.begin(), header.end(), column);
        if (found == header.end()) { throw std::runtime_error(name + " has no column " + column); }
        places.push_back(static_cast<std::size_t>(found - header.begin()));
    }
    std::vector<std::vector<double>> rows;
    while (std::getline(file, line)) {
        const auto all = cells(line);
        std::vector<double> row;
        for (const auto place : places) { row.push_back(std::stod(all.at(place))); }
        rows.push_back(row);
    }
    return rows;
}

Eigen::Vector3d same(double x) { return Eigen::Vector3d(x, x, x); }

GINSOptions options(const std::map<std::string, double> &settings, const std::map<std::string, double> &initial) {
    const auto set = [&](const char *key) { return settings.at(key); };
    const auto start = [&](const char *key) { return initial.at(key); };
    GINSOptions all;
    NavState &state = all.initstate, &sigma = all.initstate_std;
    state.pos << start("latitude_deg") * degree, start("longitude_deg") * degree, start("altitude_m");
    state.vel << start("north_m_s"), start("east_m_s"), start("down_m_s");
    state.euler << start("roll_deg") * degree, start("pitch_deg") * degree, start("yaw_deg") * degree;
    state.imuerror = { same(0), same(0), same(0), same(0) };
    sigma.pos = same(set("position_m"));
    sigma.vel = same(set("velocity_m_s"));
    sigma.euler << set("level_rad"), set("level_rad"), set("heading_rad");
    const auto gyro = same(set("gyro_bias_rad_s")), accelerometer = same(set("accelerometer_bias_m_s2"));
    sigma.imuerror = { gyro, accelerometer, same(no_scale), same(no_scale) };
    all.imunoise = { same(set("gyro_noise_rad_root_s")), same(set("accelerometer_noise_m_s_root_s")), gyro,
                     accelerometer, same(no_scale), same(no_scale), forever_s };
    all.antlever << set("lever_forward_m"), set("lever_right_m"), set("lever_down_m");
    return all;
}

struct Flight {
    std::vector<IMU> samples;
    std::vector<GNSS> fixes;
    GINSOptions options;
};

Flight read(const std::string &folder) {
    const auto settings = flat(folder + "/settings.toml");
    Flight flight{ {}, {}, options(settings, flat(folder + "/initial.toml")) };
    const double interval_s = 1 / settings.at("rate_hz"), sigma = settings.at("fix_position_m");
    for (const auto &row : table(folder + "/imu.csv", { "time_s", "dtheta_x_rad", "dtheta_y_rad", "dtheta_z_rad",
                                                        "dvel_x_m_s", "dvel_y_m_s", "dvel_z_m_s" })) {
        const Eigen::Vector3d angle(row[1], row[2], row[3]), velocity(row[4], row[5], row[6]);
        flight.samples.push_back({ row[0], interval_s, angle, velocity, 0 });
    }
    for (const auto &row : table(folder + "/gnss.csv", { "time_s", "latitude_deg", "longitude_deg", "altitude_m" })) {
        const Eigen::Vector3d place(row[1] * degree, row[2] * degree, row[3]);
        flight.fixes.push_back({ row[0], place, same(sigma), true });
    }
    return flight;
}

// Flies it, and shows the engine after each sample.
template <typename Seen> void fly(Flight flight, Seen seen) {
    GIEngine engine(flight.options);
    // The state is that of time 0, where the engine wants a sample that is past.
    IMU before = flight.samples.at(0);
    before.time = 0;
    engine.addImuData(before, true);
    // The engine waits for one fix at a time.
    std::size_t waits = 0;
    engine.addGnssData(flight.fixes.at(waits));
    double last_s = before.time;
    for (const IMU &sample : flight.samples) {
        if (flight.fixes[waits].time <= last_s && waits + 1 < flight.fixes.size()) {
            engine.addGnssData(flight.fixes[++waits]);
        }
        last_s = sample.time;
        engine.addImuData(sample);
        engine.newImuProcess();
        seen(engine);
    }
}

void write(const std::string &folder) {
    const Flight flight = read(folder);
    const auto begun = std::clock();
    fly(flight, [](GIEngine &) {});
    const double seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    std::ofstream(folder + "/KF-GINS.cost") << seconds / static_cast<double>(flight.samples.size()) * 1e6 << '\n';

    std::ofstream rows(folder + "/KF-GINS.csv");
    rows << "time_s,latitude_deg,longitude_deg,altitude_m,north_m_s,east_m_s,down_m_s,roll_deg,pitch_deg,yaw_deg,"
            "north_m_sigma,east_m_sigma,down_m_sigma\n"
         << std::setprecision(17);
    int since = 0;
    fly(flight, [&](GIEngine &engine) {
        if (++since % 10 != 0) { return; }
        const NavState state = engine.getNavState();
        const Eigen::MatrixXd covariance = engine.getCovariance();
        rows << engine.timestamp() << ',' << state.pos[0] / degree << ',' << state.pos[1] / degree << ',' << state.pos[2];
        for (int i = 0; i < 3; ++i) { rows << ',' << state.vel[i]; }
        for (int i = 0; i < 3; ++i) { rows << ',' << state.euler[i] / degree; }
        for (int i = 0; i < 3; ++i) { rows << ',' << std::sqrt(covariance(i, i)); }
        rows << '\n';
    });
    if (!rows.flush()) { throw std::runtime_error(folder + "/KF-GINS.csv cannot be written"); }
}

} // namespace

int main(int count, char **names) {
    try {
        for (int i = 1; i < count; ++i) { write(names[i]); }
    } catch (const std::exception &error) {
        std::cerr << "fly_kf_gins: " << error.what() << '\n';
        return 1;
    }
}
