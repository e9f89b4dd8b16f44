// What the programs in C++ share: the law of contact as numbers, and the command line
//
//     PROGRAM --history      the nominal run as a table of `time_s,slider_x_m`
//     PROGRAM --runs N       {"runs":N,"seconds":S,...}: N runs, S the processor time of all of them
#pragma once

#include "parameters.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

constexpr int TURNS = 2;
constexpr int READINGS_PER_TURN = 1000;
constexpr int RUNS_AHEAD = 3; ///< runs before the clock starts: they fill caches
constexpr double VARIATION = 0.1; ///< clearances lie evenly within this share around the nominal one
constexpr double TURN_S = 6.283185307179586 / CRANK_SPEED_RAD_S;

struct RunCount {
    std::uint64_t steps, evaluations;
};

/// K of the contact law: two spheres of these radii, the bearing's held, two equal materials, N/m^1.5.
inline double contact_stiffness(double clearance_m) {
    const double compliance = (1.0 - POISSON_RATIO * POISSON_RATIO) / YOUNGS_MODULUS_PA;
    return 4.0 / (3.0 * 2.0 * compliance) *
           std::sqrt(BEARING_RADIUS_M * (BEARING_RADIUS_M - clearance_m) / clearance_m);
}

/// Lankarani and Nikravesh's χ.
constexpr double damping_factor() { return 0.75 * (1.0 - RESTITUTION * RESTITUTION); }

inline double processor_time_s() {
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

/// Clearance of run `index` of `runs`, m.
inline double clearance_of_m(int index, int runs) {
    return CLEARANCE_M * (1.0 + VARIATION * (2.0 * (index + 0.5) / runs - 1.0));
}

template <class Run> void print_history(Run run) {
    std::vector<double> slider_x_m(TURNS * READINGS_PER_TURN + 1);
    run(CLEARANCE_M, slider_x_m.data());
    std::puts("time_s,slider_x_m");
    for (std::size_t i = 0; i < slider_x_m.size(); ++i)
        std::printf("%.12e,%.15e\n", TURN_S / READINGS_PER_TURN * i, slider_x_m[i]);
}

template <class Run> void print_batch(Run run, int runs) {
    std::vector<double> slider_x_m(TURNS * READINGS_PER_TURN + 1);
    for (int index = 0; index < RUNS_AHEAD; ++index) run(clearance_of_m(index, RUNS_AHEAD), slider_x_m.data());
    double sum_m = 0.0;
    RunCount total{0, 0};
    const double started_s = processor_time_s();
    for (int index = 0; index < runs; ++index) {
        const RunCount one = run(clearance_of_m(index, runs), slider_x_m.data());
        total.steps += one.steps;
        total.evaluations += one.evaluations;
        for (const double x_m : slider_x_m) sum_m += x_m;
    }
    const double seconds = processor_time_s() - started_s;
    std::printf("{\"runs\":%d,\"seconds\":%.6f,\"steps_per_run\":%.1f,\"evaluations_per_run\":%.1f,\"mean_x_m\":%.6f}\n",
                runs, seconds, double(total.steps) / runs, double(total.evaluations) / runs,
                sum_m / runs / slider_x_m.size());
}

template <class Run> int program_main(int count, char **arguments, Run run) {
    const int runs = count == 3 && std::strcmp(arguments[1], "--runs") == 0 ? std::atoi(arguments[2]) : 0;
    if (count == 2 && std::strcmp(arguments[1], "--history") == 0) print_history(run);
    else if (runs > 0) print_batch(run, runs);
    else {
        std::fprintf(stderr, "usage: %s --history | --runs N (N >= 1)\n", arguments[0]);
        return 2;
    }
    return 0;
}
