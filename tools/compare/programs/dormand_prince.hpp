// Dormand and Prince's pair of order 5(4) with its continuous extension, for two coordinates and their rates, with contact
// onsets and separations located as roots of the gap on the continuous extension. A `System` gives
//
//     State derivative(double time_s, const State &state);   the right-hand side in the present contact state
//     Gap gap(double time_s, const State &state);            |e|² - c² and half its rate
//     void begin_contact(double time_s, const State &state), end_contact();
//     bool in_contact() const;
//
// Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I", II.5 (pair), II.6 (continuous extension).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

/// Two coordinates and their rates, or the rates of these. Four names instead of an array: a step is one long chain of
/// operations, and compilers keep such a chain in registers only where nothing can be indexed.
struct State {
    double q1, q2, v1, v2;
};
inline State operator+(const State &a, const State &b) { return {a.q1 + b.q1, a.q2 + b.q2, a.v1 + b.v1, a.v2 + b.v2}; }
inline State operator-(const State &a, const State &b) { return {a.q1 - b.q1, a.q2 - b.q2, a.v1 - b.v1, a.v2 - b.v2}; }
inline State operator*(double s, const State &a) { return {s * a.q1, s * a.q2, s * a.v1, s * a.v2}; }

/// |e|² - c² and (e·ė): the sign of the first tells contact, the second is half its rate.
struct Gap {
    double square_m2;
    double half_rate_m2_s;
};

/// What an integration is allowed to do.
struct Accuracy {
    double relative;         ///< allowed error of a step over `1 + |state|`, entry by entry
    double first_step_s;     ///< also after an event before anything better is known
    double largest_step_s;
};

template <class System> class DormandPrince {
public:
    DormandPrince(System &system, const Accuracy &accuracy) : system(system), accuracy(accuracy) {}

    std::uint64_t evaluations = 0;
    std::uint64_t steps = 0;

    /// From time zero through `readings` intervals of `interval_s`; the second coordinate at their ends goes into `values`,
    /// whose first entry is that at the start.
    void run(const State &start, double interval_s, int readings, double *values) {
        double time_s = 0.0;
        const double end_s = interval_s * readings;
        state = start;
        values[0] = state.q2;
        int next = 1;
        slope_start = derivative(time_s, state);
        Gap gap_start = system.gap(time_s, state);
        double step_s = accuracy.first_step_s;
        double after_event_s[2] = {accuracy.first_step_s, accuracy.first_step_s};
        int last_event = -1;
        while (next <= readings) {
            step_s = std::min({step_s, accuracy.largest_step_s, end_s - time_s});
            const double error = attempt(time_s, step_s);
            if (!(error <= 1.0)) {
                if (!(step_s > 1e-18)) std::abort(); // not finite, or hopeless
                step_s *= std::max(0.2, 0.9 * std::pow(error, -0.2));
                continue;
            }
            ++steps;
            const Gap gap_end = system.gap(time_s + step_s, state_end);
            prepare_extension(step_s);
            const double share = event_share(time_s, step_s, gap_start, gap_end);
            const double taken_s = share < 1.0 ? share * step_s : step_s;
            const double reached_s = end_s - (time_s + taken_s) < 1e-15 ? end_s : time_s + taken_s;
            for (; next <= readings && interval_s * next <= reached_s; ++next)
                values[next] = second_coordinate_at((interval_s * next - time_s) / step_s);
            if (share < 1.0) {
                state = at(share);
                time_s = reached_s;
                const int event = system.in_contact() ? 0 : 1;
                if (system.in_contact()) system.end_contact();
                else system.begin_contact(time_s, state);
                slope_start = derivative(time_s, state);
                gap_start = system.gap(time_s, state);
                step_s = after_event_s[event];
                last_event = event;
            } else {
                if (last_event >= 0) after_event_s[last_event] = taken_s;
                last_event = -1;
                time_s = reached_s;
                state = state_end;
                slope_start = slope_end;
                gap_start = gap_end;
                step_s *= std::min(6.0, 0.9 * std::pow(std::max(error, 1e-10), -0.2));
            }
        }
    }

private:
    System &system;
    Accuracy accuracy;
    State state, state_end, slope_start, slope_end;
    State k3, k4, k5, k6;
    State extension[5];

    State derivative(double time_s, const State &at_state) {
        ++evaluations;
        return system.derivative(time_s, at_state);
    }

    /// One step; gives its error over the allowed one.
    double attempt(double time_s, double h) {
        const State k1 = slope_start;
        const State k2 = derivative(time_s + h * (1.0 / 5.0), state + h * (1.0 / 5.0) * k1);
        k3 = derivative(time_s + h * (3.0 / 10.0), state + h * ((3.0 / 40.0) * k1 + (9.0 / 40.0) * k2));
        k4 = derivative(time_s + h * (4.0 / 5.0),
                        state + h * ((44.0 / 45.0) * k1 - (56.0 / 15.0) * k2 + (32.0 / 9.0) * k3));
        k5 = derivative(time_s + h * (8.0 / 9.0),
                        state + h * ((19372.0 / 6561.0) * k1 - (25360.0 / 2187.0) * k2 + (64448.0 / 6561.0) * k3 -
                                     (212.0 / 729.0) * k4));
        k6 = derivative(time_s + h, state + h * ((9017.0 / 3168.0) * k1 - (355.0 / 33.0) * k2 + (46732.0 / 5247.0) * k3 +
                                                 (49.0 / 176.0) * k4 - (5103.0 / 18656.0) * k5));
        state_end = state + h * ((35.0 / 384.0) * k1 + (500.0 / 1113.0) * k3 + (125.0 / 192.0) * k4 -
                                 (2187.0 / 6784.0) * k5 + (11.0 / 84.0) * k6);
        slope_end = derivative(time_s + h, state_end);
        const State defect = h * ((71.0 / 57600.0) * k1 - (71.0 / 16695.0) * k3 + (71.0 / 1920.0) * k4 -
                                    (17253.0 / 339200.0) * k5 + (22.0 / 525.0) * k6 - (1.0 / 40.0) * slope_end);
        const State &y = state, &z = state_end;
        const double sum = share_of_allowed(defect.q1, y.q1, z.q1) + share_of_allowed(defect.q2, y.q2, z.q2) +
                           share_of_allowed(defect.v1, y.v1, z.v1) + share_of_allowed(defect.v2, y.v2, z.v2);
        return std::sqrt(0.25 * sum);
    }

    /// The square of a defect over what is allowed.
    double share_of_allowed(double defect, double from, double to) const {
        const double scaled = defect / (accuracy.relative * (1.0 + std::max(std::abs(from), std::abs(to))));
        return scaled * scaled;
    }

    void prepare_extension(double h) {
        const State difference = state_end - state;
        const State bump = h * slope_start - difference;
        extension[0] = state;
        extension[1] = difference;
        extension[2] = bump;
        extension[3] = difference - h * slope_end - bump;
        extension[4] = h * ((-12715105075.0 / 11282082432.0) * slope_start + (87487479700.0 / 32700410799.0) * k3 -
                            (10690763975.0 / 1880347072.0) * k4 + (701980252875.0 / 199316789632.0) * k5 -
                            (1453857185.0 / 822651844.0) * k6 + (69997945.0 / 29380423.0) * slope_end);
    }

    State at(double share) const {
        const double rest = 1.0 - share;
        return extension[0] +
               share * (extension[1] + rest * (extension[2] + share * (extension[3] + rest * extension[4])));
    }

    double second_coordinate_at(double share) const {
        const double rest = 1.0 - share;
        return extension[0].q2 +
               share * (extension[1].q2 +
                        rest * (extension[2].q2 + share * (extension[3].q2 + rest * extension[4].q2)));
    }

    /// Where in the step the contact changes, as a share of the step; 2 where it does not.
    double event_share(double time_s, double h, const Gap &start, const Gap &end) {
        const double sign = system.in_contact() ? -1.0 : 1.0;
        double low = 0.0, high = 1.0;
        if (!(sign * end.square_m2 > 0.0)) {
            // A touch that begins and ends inside the step: look at the top of the gap.
            if (!(sign * start.half_rate_m2_s > 0.0 && sign * end.half_rate_m2_s < 0.0)) return 2.0;
            double left = 0.0, right = 1.0;
            bool found = false;
            for (int i = 0; i < 40 && !found && right - left > 1e-6; ++i) {
                const double middle = 0.5 * (left + right);
                const Gap gap = system.gap(time_s + middle * h, at(middle));
                found = sign * gap.square_m2 > 0.0;
                if (found) high = middle;
                else (sign * gap.half_rate_m2_s > 0.0 ? left : right) = middle;
            }
            if (!found) return 2.0;
        }
        // Newton's iteration, kept inside the bracket.
        double share = 0.5 * high;
        if (sign * start.square_m2 < 0.0) share = high * start.square_m2 / (start.square_m2 - end.square_m2);
        if (!(share > low && share < high)) share = 0.5 * high;
        for (int i = 0; i < 60; ++i) {
            const Gap gap = system.gap(time_s + share * h, at(share));
            (sign * gap.square_m2 > 0.0 ? high : low) = share;
            double next = share - gap.square_m2 / (2.0 * h * gap.half_rate_m2_s);
            if (!(next > low && next < high)) next = 0.5 * (low + high);
            const double moved = std::abs(next - share);
            share = next;
            if (moved < 1e-13) break;
        }
        return share;
    }
};
