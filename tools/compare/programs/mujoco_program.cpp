// MuJoCo with its own integrator of order four at a fixed step; contact by the callback of mujoco_model.hpp.

#include "mujoco_model.hpp"

namespace {

using namespace slider_crank;

constexpr int STEPS_PER_READING = 12; // 1 µs; with 11, 10 and 9 the limit of the error is missed
constexpr double STEP_S = TURN_S / READINGS_PER_TURN / STEPS_PER_READING;

/// Depth and rate at the end of a step.
struct Approach {
    double depth_m, rate_m_s;
};

/// Speed at depth zero from the two steps before it, both in flight: the rate is continued along a line.
double speed_at_onset_m_s(const Approach &before, const Approach &last) {
    const double acceleration_m_s2 = (last.rate_m_s - before.rate_m_s) / STEP_S;
    double left_s = -last.depth_m / last.rate_m_s;
    left_s = -last.depth_m / (last.rate_m_s + 0.5 * acceleration_m_s2 * left_s);
    return last.rate_m_s + acceleration_m_s2 * left_s;
}

Approach approach(const mjData *data) {
    // mj_step leaves the positions of bodies as they were before it, so the state is read instead.
    const double crank_rad = data->qpos[CRANK], rod_rad = crank_rad + data->qpos[ROD];
    double crank_sine, crank_cosine, rod_sine, rod_cosine;
    sincos(crank_rad, &crank_sine, &crank_cosine);
    sincos(rod_rad, &rod_sine, &rod_cosine);
    const double crank_m_s = CRANK_LENGTH_M * data->qvel[CRANK];
    const double rod_m_s = ROD_LENGTH_M * (data->qvel[CRANK] + data->qvel[ROD]);
    const double x_m = data->qpos[SLIDER] - CRANK_LENGTH_M * crank_cosine - ROD_LENGTH_M * rod_cosine;
    const double y_m = -CRANK_LENGTH_M * crank_sine - ROD_LENGTH_M * rod_sine;
    const double vx_m_s = data->qvel[SLIDER] + crank_m_s * crank_sine + rod_m_s * rod_sine;
    const double vy_m_s = -crank_m_s * crank_cosine - rod_m_s * rod_cosine;
    const double length_m = std::sqrt(x_m * x_m + y_m * y_m);
    return {length_m - contact.clearance_m, length_m > 0.0 ? (x_m * vx_m_s + y_m * vy_m_s) / length_m : 0.0};
}

RunCount run(double clearance_m, double *slider_x_m) {
    static Simulator simulator;
    simulator.start(clearance_m);
    mjData *data = simulator.data;
    simulator.model->opt.timestep = STEP_S;
    Approach before = approach(data), last = before;
    slider_x_m[0] = data->qpos[SLIDER];
    for (int reading = 1; reading <= TURNS * READINGS_PER_TURN; ++reading) {
        for (int step = 0; step < STEPS_PER_READING; ++step) {
            // A step that will touch is taken with the speed at which it will.
            if (!contact.is_closed && last.rate_m_s > 0.0 && last.depth_m + STEP_S * last.rate_m_s + 1e-7 > 0.0)
                begin_contact(speed_at_onset_m_s(before, last));
            mj_step(simulator.model, data);
            before = last;
            last = approach(data);
            // A touch that was foreseen and did not come, or one that is over.
            if (contact.is_closed && !(last.depth_m > 0.0)) contact.is_closed = false;
        }
        slider_x_m[reading] = data->qpos[SLIDER];
    }
    const std::uint64_t steps = std::uint64_t(TURNS) * READINGS_PER_TURN * STEPS_PER_READING;
    return {steps, 4 * steps};
}

} // namespace

int main(int count, char **arguments) { return program_main(count, arguments, run); }
