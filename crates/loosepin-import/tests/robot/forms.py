"""Writes forms.csv: poses and masses of forms.xml by MuJoCo 4.0.0 (pip install mujoco), from this folder.

Rows of poses: coordinates j1 (rad), j2 (m), j3 (m), j4 (rad), j5 (rad); the body; its place; x and y of its axes.
Rows of masses: the body; mass, centre of mass, moments xx, yy, zz, xy, xz, yz about it in the axes of the body.
"""

import csv

import mujoco
import numpy

COORDINATES = [[0.2617993877991494, 0.07, 0.0, 0.0, 0.0], [0.9, -0.2, 0.3, 1.7, -2.3], [-1.4, 0.15, -0.05, -0.6, 2.9]]

model = mujoco.MjModel.from_xml_path("forms.xml")
data = mujoco.MjData(model)
with open("forms.csv", "w", newline="") as file:
    out = csv.writer(file, lineterminator="\n")
    for coordinates in COORDINATES:
        data.qpos[:] = coordinates
        mujoco.mj_kinematics(model, data)
        for body in "abcd":
            number = model.body(body).id
            axes = data.xmat[number].reshape(3, 3)
            values = [*data.xpos[number], *axes[:, 0], *axes[:, 1]]
            out.writerow(["pose", *coordinates, body, *(repr(float(value)) for value in values)])
    for body in "abcd":
        number = model.body(body).id
        turn = numpy.zeros(9)
        mujoco.mju_quat2Mat(turn, model.body_iquat[number])
        turn = turn.reshape(3, 3)
        inertia = turn @ numpy.diag(model.body_inertia[number]) @ turn.T
        moments = [inertia[i, j] for i, j in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]]
        values = [model.body_mass[number], *model.body_ipos[number], *moments]
        out.writerow(["mass", body, *(repr(float(value)) for value in values)])
