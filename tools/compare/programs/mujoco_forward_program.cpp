// MuJoCo's forward dynamics as the right-hand side of Dormand and Prince's pair with located contacts.
//
// Of mj_forward only the parts are called that this model needs; compiled with -DWHOLE_FORWARD it calls mj_forward itself.

#include "dormand_prince.hpp"
#include "mujoco_model.hpp"

namespace {

using namespace slider_crank;

constexpr Accuracy ACCURACY{1e-7, 1e-6, 1e-4};

/// State: angle of the rod to the crank, x of the slider, their rates. The crank's angle is the speed times the time.
class MujocoSystem {
public:
    explicit MujocoSystem(Simulator &simulator) : model(simulator.model), data(simulator.data) {}

    State start() const { return {data->qpos[ROD], data->qpos[SLIDER], data->qvel[ROD], data->qvel[SLIDER]}; }

    State derivative(double time_s, const State &y) {
        data->time = time_s;
        data->qpos[CRANK] = CRANK_SPEED_RAD_S * time_s;
        data->qvel[CRANK] = CRANK_SPEED_RAD_S;
        data->qpos[ROD] = y.q1;
        data->qpos[SLIDER] = y.q2;
        data->qvel[ROD] = y.v1;
        data->qvel[SLIDER] = y.v2;
#ifdef WHOLE_FORWARD
        mj_forward(model, data);
#else
        mj_kinematics(model, data);
        mj_comPos(model, data);
        mj_makeM(model, data);
        mj_factorM(model, data);
        mj_comVel(model, data);
        mju_zero(data->qfrc_passive, 3);
        add_contact_force(model, data);
        mj_rne(model, data, 0, data->qfrc_bias);
        mju_sub(data->qfrc_smooth, data->qfrc_passive, data->qfrc_bias, 3);
        mj_solveM(model, data, data->qacc, data->qfrc_smooth, 1);
#endif
        return {y.v1, y.v2, data->qacc[ROD], data->qacc[SLIDER]};
    }

    /// In closed form, so that looking for a contact costs no evaluation.
    Gap gap(double time_s, const State &y) const {
        const double crank_rad = CRANK_SPEED_RAD_S * time_s, rod_m_s = ROD_LENGTH_M * (CRANK_SPEED_RAD_S + y.v1);
        constexpr double crank_m_s = CRANK_LENGTH_M * CRANK_SPEED_RAD_S;
        double crank_sine, crank_cosine, rod_sine, rod_cosine;
        sincos(crank_rad, &crank_sine, &crank_cosine);
        sincos(crank_rad + y.q1, &rod_sine, &rod_cosine);
        const double x_m = y.q2 - CRANK_LENGTH_M * crank_cosine - ROD_LENGTH_M * rod_cosine;
        const double y_m = -CRANK_LENGTH_M * crank_sine - ROD_LENGTH_M * rod_sine;
        const double vx_m_s = y.v2 + crank_m_s * crank_sine + rod_m_s * rod_sine;
        const double vy_m_s = -crank_m_s * crank_cosine - rod_m_s * rod_cosine;
        return {x_m * x_m + y_m * y_m - contact.clearance_m * contact.clearance_m, x_m * vx_m_s + y_m * vy_m_s};
    }

    bool in_contact() const { return contact.is_closed; }
    void end_contact() { contact.is_closed = false; }
    void begin_contact(double time_s, const State &y) {
        slider_crank::begin_contact(gap(time_s, y).half_rate_m2_s / contact.clearance_m);
    }

private:
    const mjModel *model;
    mjData *data;
};

RunCount run(double clearance_m, double *slider_x_m) {
    static Simulator simulator;
    simulator.start(clearance_m);
    MujocoSystem system(simulator);
    DormandPrince<MujocoSystem> integration(system, ACCURACY);
    integration.run(system.start(), TURN_S / READINGS_PER_TURN, TURNS * READINGS_PER_TURN, slider_x_m);
    return {integration.steps, integration.evaluations};
}

} // namespace

int main(int count, char **arguments) { return program_main(count, arguments, run); }
