"""The model file of a random mechanism: numbers with all their digits, in SI."""

UNITS = {
    "lower_speed": "m/s", "upper_speed": "m/s", "transition_speed": "m/s", "stribeck_speed": "m/s", "decay": "s/m",
    "bristle_stiffness": "m^-1", "bristle_damping": "s/m", "viscous": "s/m",
}


def q(value, unit):
    return f'"{float(value)!r} {unit}"'


def friction(law, literal=False):
    parts = [f'law = "{law.name}"']
    for key, value in law.numbers.items():
        parts.append(f"{key} = {q(value, UNITS[key])}" if key in UNITS else f"{key} = {float(value)!r}")
    if literal:
        parts.append('sliding_velocity = "literal"')
    return "{ " + ", ".join(parts) + " }"


def text(mechanism, samples):
    lines = ['name = "random mechanism"', f"gravity = {q(mechanism.gravity, 'm/s^2')}"]
    for index, body in enumerate(mechanism.bodies):
        lines.append(f"\n[body.{body.name}]")
        if index > 0:
            lines += [f"mass = {q(body.mass, 'kg')}", f"inertia = {q(body.inertia, 'kg m^2')}",
                      f"centre_of_mass = [{q(body.centre[0], 'm')}, {q(body.centre[1], 'm')}]"]
        points = ", ".join(f"p{k} = [{q(x, 'm')}, {q(y, 'm')}]" for k, (x, y) in enumerate(body.points))
        lines.append(f"points = {{ {points} }}")
    for joint in mechanism.joints:
        lines += joint_lines(joint)
    for spring in mechanism.springs:
        if spring.kind == "linear":
            lines += [f"\n[spring.{spring.name}]", 'kind = "linear"', f'first = "{spring.names[0]}"', f'second = "{spring.names[1]}"',
                      f"stiffness = {q(spring.stiffness, 'N/m')}", f"free_length = {q(spring.free, 'm')}",
                      f"damping = {q(spring.damping, 'N s/m')}", f"preload = {q(spring.preload, 'N')}"]
        else:
            first, second = (mechanism.bodies[b].name for b in spring.bodies)
            lines += [f"\n[spring.{spring.name}]", 'kind = "torsional"', f'first = "{first}"', f'second = "{second}"',
                      f"stiffness = {q(spring.stiffness, 'N m/rad')}", f"free_angle = {q(spring.free, 'rad')}",
                      f"damping = {q(spring.damping, 'N m s/rad')}", f"preload = {q(spring.preload, 'N m')}"]
    for load in mechanism.loads:
        unit = "N" if load.kind == "force" else "N m"
        size = q(load.mean, unit)
        if load.harmonic:
            size = (f"{{ mean = {q(load.mean, unit)}, amplitude = {q(load.amplitude, unit)}, "
                    f"frequency = {q(load.frequency, 'Hz')}, phase = {q(load.phase, 'rad')} }}")
        lines += [f"\n[load.{load.name}]", f'kind = "{load.kind}"', f"{load.kind} = {size}"]
        if load.kind == "force":
            lines += [f'point = "{load.point_name}"', f"direction = {q(load.direction, 'rad')}",
                      f'frame = "{"body" if load.follows else "ground"}"']
        else:
            lines.append(f'body = "{mechanism.bodies[load.body].name}"')
    initial = []
    for joint in mechanism.joints:
        if joint.drive:
            lines += drive_lines(joint)
        elif joint.rates.get("is_initial"):
            initial.append(f"\n[initial.joint.{joint.name}]")
            turning = joint.rates["turning_body"]
            if turning is not None:
                body = mechanism.bodies[turning]
                initial.append(f"position = {q(joint.rates['position'], 'm')}\nvelocity = {q(joint.rates['position_rate'], 'm/s')}")
                initial += [f"\n[initial.body.{body.name}]", f"angle = {q(body.pose[2], 'rad')}",
                            f"angular_velocity = {q(joint.rates['angle_rate'], 'rad/s')}"]
                continue
            for key in joint.rates["is_initial"]:
                unit, rate = ("rad", "angular_velocity") if key == "angle" else ("m", "velocity")
                initial += [f"{key} = {q(joint.rates[key], unit)}", f"{rate} = {q(joint.rates[key + '_rate'], unit + '/s')}"]
    lines += initial
    if mechanism.looped:
        guesses = ", ".join(f"{mechanism.bodies[b].name} = {q(mechanism.bodies[b].pose[2], 'rad')}" for b in sorted(mechanism.looped))
        lines += ["\n[assembly]", f"guess = {{ {guesses} }}"]
    lines += ["\n[cycle]", f"duration = {q(mechanism.duration, 's')}", "recorded_turns = 1", f"samples_per_turn = {samples}"]
    return "\n".join(lines) + "\n"


def joint_lines(joint):
    first, second = joint.names
    lines = [f"\n[joint.{joint.name}]", f'kind = "{joint.kind}"']
    if joint.kind == "revolute":
        lines += [f'bearing = "{first}"', f'journal = "{second}"']
    elif joint.kind == "prismatic":
        lines += [f'guide = {{ point = "{first}", angle = {q(joint.angles[0], "rad")} }}',
                  f'slider = {{ point = "{second}", angle = {q(joint.angles[1], "rad")} }}']
    elif joint.kind == "slot":
        lines += [f'slot = {{ point = "{first}", angle = {q(joint.angles[0], "rad")} }}', f'pin = "{second}"']
    else:
        lines += [f'first = "{first}"', f'second = "{second}"', f"angle = {q(joint.angles[0], 'rad')}"]
    if joint.friction:
        key = "pin_radius" if joint.kind == "revolute" else "guide_length"
        lines += [f"friction = {friction(joint.friction)}", f"{key} = {q(joint.size, 'm')}"]
    play = joint.play
    if play is None:
        return lines
    if joint.kind == "revolute":
        lines += [f"bearing_radius = {q(play.radius, 'm')}", f"radial_clearance = {q(play.clearance, 'm')}",
                  f"bearing_length = {q(play.length, 'm')}"]
    elif joint.kind == "prismatic":
        lines += [f"half_length = {q(play.half_length, 'm')}", f"half_height = {q(play.half_height, 'm')}",
                  f"clearance = {q(play.clearance, 'm')}"]
        if play.contact.stiffness is None:
            lines.append(f"corner_radius = {q(play.corner_radius, 'm')}")
    else:
        lines += [f"half_length = {q(play.slot_half_length, 'm')}", f"end_radius = {q(play.radius, 'm')}",
                  f"clearance = {q(play.clearance, 'm')}"]
    lines.append(f'contact = "c_{joint.name}"')
    contact = play.contact
    lines += [f"\n[contact.c_{joint.name}]", f'law = "{contact.law}"', f"minimum_impact_speed = {q(contact.floor, 'm/s')}"]
    if contact.law == "kelvin-voigt":
        lines.append(f"damping_coefficient = {q(contact.damping, 'N s/m')}")
    else:
        lines.append(f"restitution = {contact.restitution!r}")
    if contact.damping_law:
        lines.append(f'damping = "{contact.damping_law}"')
    if contact.stiffness is not None:
        n = contact.exponent
        lines.append(f"stiffness = {q(contact.stiffness, 'N/m' if n == 1 else f'N/m^{n}')}")
        if contact.law not in ("kelvin-voigt", "anagnostopoulos", "exact-linear-restitution"):
            lines.append(f"exponent = {n!r}")
    else:
        for side, modulus, poisson in zip(("bearing", "journal"), contact.modulus, contact.poisson):
            lines += [f"{side}_youngs_modulus = {q(modulus, 'Pa')}", f"{side}_poisson_ratio = {float(poisson)!r}"]
    if play.friction:
        lines.append(f"friction = {friction(play.friction, play.literal)}")
    if play.film:
        lines.append(f'film = {{ law = "{play.film.law}", viscosity = {q(play.film.viscosity, "Pa s")}, '
                     f'roughness = {q(play.film.roughness, "m")} }}')
    return lines


def drive_lines(joint):
    drive, unit = joint.drive, "rad" if joint.kind == "revolute" else "m"
    lines = [f"\n[drive.d_{joint.name}]", f'joint = "{joint.name}"']
    if drive.kind == "constant":
        key = "start_angle" if unit == "rad" else "start_position"
        return lines + [f"speed = {q(drive.rate, unit + '/s')}", f"{key} = {q(drive.start, unit)}"]
    if drive.kind == "harmonic":
        return lines + [f'motion = {{ kind = "harmonic", mean = {q(drive.mean, unit)}, amplitude = {q(drive.amplitude, unit)}, '
                        f'frequency = {q(drive.frequency, "Hz")}, phase = {q(drive.phase, "rad")} }}']
    powers = [unit, unit + "/s", unit + "/s^2"]
    coefficients = ", ".join(q(value, power) for value, power in zip(drive.coefficients, powers))
    return lines + [f'motion = {{ kind = "polynomial", coefficients = [{coefficients}] }}']
