// The slider-crank with a loose gudgeon, its equations of motion written by hand for it, in Dormand and Prince's pair with
// located contacts. Compiled with -O3 -march=native and the numbers of the model as constants;
// with -DALLOWED_ERROR=1e-9 it meets this library's limit at the nominal clearance.

#include "dormand_prince.hpp"
#include "parameters.hpp"
#include "program.hpp"

namespace {

#ifndef ALLOWED_ERROR
#define ALLOWED_ERROR 1e-7
#endif
constexpr Accuracy ACCURACY{ALLOWED_ERROR, 1e-6, 1e-4}; // relative, first step, largest step

/// State: angle of the rod, x of the slider, their rates. The crank's angle is the speed times the time.
class SliderCrank {
public:
    explicit SliderCrank(double clearance_m)
        : clearance_m(clearance_m), clearance_square_m2(clearance_m * clearance_m),
          stiffness(contact_stiffness(clearance_m)) {}

    State start() const {
        return {0.0, CRANK_LENGTH_M + ROD_LENGTH_M, -CRANK_SPEED_RAD_S * CRANK_LENGTH_M / ROD_LENGTH_M, 0.0};
    }

    State derivative(double time_s, const State &y) {
        const Eccentricity e = eccentricity(time_s, y);
        double force_x_n = 0.0, force_y_n = 0.0; // on the rod; the slider gets the opposite
        if (contact > 0.0) {
            const double length_m = std::sqrt(e.x * e.x + e.y * e.y);
            const double penetration_m = length_m - clearance_m;
            if (penetration_m > 0.0) {
                const double inverse_length_1_m = 1.0 / length_m;
                const double penetration_rate_m_s = (e.x * e.vx + e.y * e.vy) * inverse_length_1_m;
                const double elastic_n = stiffness * penetration_m * std::sqrt(penetration_m);
                const double normal_n = std::max(elastic_n * (1.0 + damping_s_m * penetration_rate_m_s), 0.0);
                force_x_n = normal_n * inverse_length_1_m * e.x;
                force_y_n = normal_n * inverse_length_1_m * e.y;
            }
        }
        constexpr double arm_m = ROD_CENTRE_M;
        constexpr double inverse_inertia = 1.0 / (ROD_INERTIA_KG_M2 + ROD_MASS_KG * arm_m * arm_m);
        constexpr double crank_pin_m_s2 = CRANK_SPEED_RAD_S * CRANK_SPEED_RAD_S * CRANK_LENGTH_M;
        const double moment_n_m =
            ROD_MASS_KG * arm_m *
                ((crank_pin_m_s2 * crank.sine - GRAVITY_M_S2) * rod.cosine - crank_pin_m_s2 * crank.cosine * rod.sine) +
            ROD_LENGTH_M * (rod.cosine * force_y_n - rod.sine * force_x_n);
        return {y.v1, y.v2, moment_n_m * inverse_inertia, -force_x_n * (1.0 / SLIDER_MASS_KG)};
    }

    Gap gap(double time_s, const State &y) {
        const Eccentricity e = eccentricity(time_s, y);
        return {e.x * e.x + e.y * e.y - clearance_square_m2, e.x * e.vx + e.y * e.vy};
    }

    bool in_contact() const { return contact > 0.0; }
    void end_contact() { contact = 0.0; }
    void begin_contact(double time_s, const State &y) {
        contact = 1.0;
        const double speed_m_s = gap(time_s, y).half_rate_m2_s / clearance_m;
        damping_s_m = damping_factor() / std::max(speed_m_s, SMALLEST_IMPACT_SPEED_M_S);
    }

private:
    /// Journal (slider) minus bearing (rod), and its rate.
    struct Eccentricity {
        double x, y, vx, vy;
    };

    /// Sines and cosines, kept because the last two stages of a step and the gap at its end share theirs.
    struct Turn {
        double angle_rad = NAN, sine = 0.0, cosine = 0.0;
        void to(double new_angle_rad) {
            if (new_angle_rad == angle_rad) return;
            angle_rad = new_angle_rad;
            sincos(angle_rad, &sine, &cosine);
        }
    };

    Eccentricity eccentricity(double time_s, const State &state) {
        crank.to(CRANK_SPEED_RAD_S * time_s);
        rod.to(state.q1);
        constexpr double crank_m_s = CRANK_LENGTH_M * CRANK_SPEED_RAD_S;
        const double rod_m_s = ROD_LENGTH_M * state.v1;
        return {state.q2 - CRANK_LENGTH_M * crank.cosine - ROD_LENGTH_M * rod.cosine,
                -CRANK_LENGTH_M * crank.sine - ROD_LENGTH_M * rod.sine,
                state.v2 + crank_m_s * crank.sine + rod_m_s * rod.sine,
                -crank_m_s * crank.cosine - rod_m_s * rod.cosine};
    }

    Turn crank, rod;
    double clearance_m, clearance_square_m2, stiffness;
    double contact = 0.0, damping_s_m = 0.0;
};

RunCount run(double clearance_m, double *slider_x_m) {
    SliderCrank system(clearance_m);
    DormandPrince<SliderCrank> integration(system, ACCURACY);
    integration.run(system.start(), TURN_S / READINGS_PER_TURN, TURNS * READINGS_PER_TURN, slider_x_m);
    return {integration.steps, integration.evaluations};
}

} // namespace

int main(int count, char **arguments) { return program_main(count, arguments, run); }
