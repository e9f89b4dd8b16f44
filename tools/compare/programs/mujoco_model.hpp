// The slider-crank for MuJoCo: two trees (crank with rod; slider), no contact of MuJoCo's own, the gudgeon's force added by
// the callback of passive forces, in C. The crank turns at constant speed because its armature is a million million times
// the inertia of everything else.
#pragma once

#include "parameters.hpp"
#include "program.hpp"

#include <mujoco/mujoco.h>

#include <string>

namespace slider_crank {

/// Addresses of the coordinates and of the bodies.
enum : int { CRANK = 0, ROD = 1, SLIDER = 2, ROD_BODY = 2, SLIDER_BODY = 3 };

/// What the callback needs to know of the contact. MuJoCo's callbacks are global, so this is, too.
struct Contact {
    double clearance_m, stiffness;
    bool is_closed;
    double damping_s_m; ///< χ/v0
};
inline Contact contact;

struct Penetration {
    double x_m, y_m, depth_m, rate_m_s, length_m;
};

/// Eccentricity of the slider's pin in the rod's eye from MuJoCo's coordinates.
inline Penetration penetration(const mjData *data) {
    const double *rod_m = data->xpos + 3 * ROD_BODY, *turn = data->xmat + 9 * ROD_BODY;
    const double arm_x_m = ROD_LENGTH_M * turn[0], arm_y_m = ROD_LENGTH_M * turn[3];
    const double crank_rad_s = data->qvel[CRANK], rod_rad_s = crank_rad_s + data->qvel[ROD];
    const double x_m = data->xpos[3 * SLIDER_BODY] - rod_m[0] - arm_x_m, y_m = -rod_m[1] - arm_y_m;
    const double vx_m_s = data->qvel[SLIDER] + crank_rad_s * rod_m[1] + rod_rad_s * arm_y_m;
    const double vy_m_s = -crank_rad_s * rod_m[0] - rod_rad_s * arm_x_m;
    const double length_m = std::sqrt(x_m * x_m + y_m * y_m);
    return {x_m, y_m, length_m - contact.clearance_m, (x_m * vx_m_s + y_m * vy_m_s) / length_m, length_m};
}

/// Adds the contact force to the passive forces; MuJoCo calls it once in each evaluation of the dynamics.
inline void add_contact_force(const mjModel *, mjData *data) {
    if (!contact.is_closed) return;
    const Penetration p = penetration(data);
    if (!(p.depth_m > 0.0)) return;
    const double elastic_n = contact.stiffness * p.depth_m * std::sqrt(p.depth_m);
    const double force_n = elastic_n * (1.0 + contact.damping_s_m * p.rate_m_s);
    if (!(force_n > 0.0)) return;
    const double x_n = force_n * p.x_m / p.length_m, y_n = force_n * p.y_m / p.length_m; // on the rod
    const double *rod_m = data->xpos + 3 * ROD_BODY, *turn = data->xmat + 9 * ROD_BODY;
    const double rod_n_m = ROD_LENGTH_M * (turn[0] * y_n - turn[3] * x_n);
    data->qfrc_passive[ROD] += rod_n_m;
    data->qfrc_passive[CRANK] += rod_n_m + rod_m[0] * y_n - rod_m[1] * x_n;
    data->qfrc_passive[SLIDER] -= x_n;
}

inline void begin_contact(double speed_m_s) {
    contact.is_closed = true;
    contact.damping_s_m = damping_factor() / std::max(speed_m_s, SMALLEST_IMPACT_SPEED_M_S);
}

/// Everything that MuJoCo does and this model does not need is off.
inline std::string description() {
    char text[4096];
    std::snprintf(text, sizeof text, R"(
<mujoco>
  <compiler angle="radian" autolimits="true" inertiafromgeom="false" boundmass="0" boundinertia="0"/>
  <option gravity="0 -%.17g 0" integrator="RK4" jacobian="dense">
    <flag constraint="disable" contact="disable" frictionloss="disable" limit="disable" equality="disable"
          warmstart="disable" actuation="disable" sensor="disable" clampctrl="disable" filterparent="disable"
          eulerdamp="disable" midphase="disable" island="disable" autoreset="disable"/>
  </option>
  <worldbody>
    <body name="crank">
      <joint name="crank" type="hinge" axis="0 0 1" armature="1e9"/>
      <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
      <body name="rod" pos="%.17g 0 0">
        <joint name="rod" type="hinge" axis="0 0 1"/>
        <inertial pos="%.17g 0 0" mass="%.17g" diaginertia="%.17g %.17g %.17g"/>
      </body>
    </body>
    <body name="slider">
      <joint name="slider" type="slide" axis="1 0 0"/>
      <inertial pos="0 0 0" mass="%.17g" diaginertia="1 1 1"/>
    </body>
  </worldbody>
</mujoco>)",
                  GRAVITY_M_S2, CRANK_LENGTH_M, ROD_CENTRE_M, ROD_MASS_KG, ROD_INERTIA_KG_M2, ROD_INERTIA_KG_M2,
                  ROD_INERTIA_KG_M2, SLIDER_MASS_KG);
    return text;
}

/// Model and state, made once; what differs between runs is in `contact`.
struct Simulator {
    mjModel *model;
    mjData *data;

    Simulator() {
        char error[1000] = "";
        mjSpec *spec = mj_parseXMLString(description().c_str(), nullptr, error, sizeof error);
        model = spec ? mj_compile(spec, nullptr) : nullptr;
        if (!model) {
            std::fprintf(stderr, "error: MuJoCo refuses the model: %s%s\n", error, spec ? mjs_getError(spec) : "");
            std::exit(1);
        }
        mj_deleteSpec(spec);
        data = mj_makeData(model);
        mjcb_passive = add_contact_force;
    }

    /// Top dead centre, journal centred, velocities of the ideal mechanism.
    void start(double clearance_m) {
        contact = {clearance_m, contact_stiffness(clearance_m), false, 0.0};
        mj_resetData(model, data);
        data->qpos[SLIDER] = CRANK_LENGTH_M + ROD_LENGTH_M;
        data->qvel[CRANK] = CRANK_SPEED_RAD_S;
        data->qvel[ROD] = -CRANK_SPEED_RAD_S * (1.0 + CRANK_LENGTH_M / ROD_LENGTH_M);
    }
};

} // namespace slider_crank
