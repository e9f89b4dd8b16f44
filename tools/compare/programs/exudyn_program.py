"""Exudyn: a kinematic tree and a mass on a line, its hollow sphere-sphere contact, DOPRI5; ../README.md says why so."""

import sys

sys.exudynFast = True  # the build without range checks, chosen before the import

import exudyn  # noqa: E402
import numpy as np  # noqa: E402
from exudyn.itemInterface import (  # noqa: E402
    MarkerBodyRigid,
    MarkerKinematicTreeRigid,
    Node1D,
    NodeGenericData,
    NodeGenericODE2,
    ObjectContactSphereSphere,
    ObjectKinematicTree,
    ObjectMass1D,
    SensorNode,
)

import program  # noqa: E402
from model import Model  # noqa: E402

ALLOWED_ERROR = 3e-7
LARGEST_STEP_S = 16e-6
SMALLEST_STEP_S = 1e-13
CONTACT_ITERATION_TOLERANCE_N = 1e3
# The crank keeps its speed because nothing moves it: a force of 1e5 N changes its angle by less than 1e-9 rad in a run.
CRANK_INERTIA_KG_M2 = 1e9


def contact_stiffness(model: Model, clearance_m: float) -> float:
    """K of the contact law with the bearing's radius held, N/m^1.5."""
    compliance = (1.0 - model.poisson_ratio**2) / model.youngs_modulus_pa
    radii_m = model.bearing_radius_m * (model.bearing_radius_m - clearance_m) / clearance_m
    return 4.0 / (3.0 * 2.0 * compliance) * radii_m**0.5


class Simulator:
    """The model, assembled once; between runs the clearance changes, and nothing else."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.container = exudyn.SystemContainer()
        self.system = self.container.AddSystem()
        self.slider_node = self._add_slider_node()
        bearing, journal = self._add_bearing(), self._add_journal()
        self.gap_node = self.system.AddNode(NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[0.0] * 4))
        self.contact = self._add_contact(bearing, journal)
        self.sensors = [self._add_sensor(what) for what in ("Coordinates", "Coordinates_t")]
        self.system.Assemble()
        self.settings = self._settings()

    def _add_bearing(self) -> int:
        """Crank and rod as a tree, from top dead centre with the velocities of the ideal mechanism; gives the rod's eye."""
        model = self.model
        rod_rad_s = -model.crank_speed_rad_s * (1.0 + model.crank_length_m / model.rod_length_m)
        angles = self.system.AddNode(
            NodeGenericODE2(
                numberOfODE2Coordinates=2,
                referenceCoordinates=[0.0, 0.0],
                initialCoordinates=[0.0, 0.0],
                initialCoordinates_t=[model.crank_speed_rad_s, rod_rad_s],
            )
        )
        inertias_kg_m2 = [CRANK_INERTIA_KG_M2, model.rod_inertia_kg_m2]
        tree = self.system.AddObject(
            ObjectKinematicTree(
                nodeNumber=angles,
                gravity=[0.0, -model.gravity_m_s2, 0.0],
                jointTypes=[exudyn.JointType.RevoluteZ] * 2,
                linkParents=[-1, 0],
                jointTransformations=exudyn.Matrix3DList([np.eye(3)] * 2),
                jointOffsets=exudyn.Vector3DList([[0.0] * 3, [model.crank_length_m, 0.0, 0.0]]),
                linkInertiasCOM=exudyn.Matrix3DList([np.diag([0.0, 0.0, inertia]) for inertia in inertias_kg_m2]),
                linkCOMs=exudyn.Vector3DList([[0.0] * 3, [model.rod_centre_m, 0.0, 0.0]]),
                linkMasses=[model.crank_mass_kg, model.rod_mass_kg],
            )
        )
        arm_m = [model.rod_length_m, 0.0, 0.0]
        return self.system.AddMarker(MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=1, localPosition=arm_m))

    def _add_slider_node(self) -> int:
        """The slider's x."""
        start_m = self.model.crank_length_m + self.model.rod_length_m
        return self.system.AddNode(
            Node1D(referenceCoordinates=[0.0], initialCoordinates=[start_m], initialVelocities=[0.0])
        )

    def _add_journal(self) -> int:
        slider = self.system.AddObject(ObjectMass1D(mass=self.model.slider_mass_kg, nodeNumber=self.slider_node))
        return self.system.AddMarker(MarkerBodyRigid(bodyNumber=slider))

    def _add_contact(self, bearing: int, journal: int) -> int:
        """The journal on the slider in the hollow sphere on the rod; radius and stiffness are set before each run.

        Hunt and Crossley's law with a restitution of 1 - (1 - c_e²)/2 is Lankarani and Nikravesh's with c_e.
        """
        model = self.model
        return self.system.AddObject(
            ObjectContactSphereSphere(
                markerNumbers=[journal, bearing],
                nodeNumber=self.gap_node,
                spheresRadii=[0.95 * model.bearing_radius_m, model.bearing_radius_m],
                isHollowSphere1=True,
                contactStiffness=1.0,
                contactStiffnessExponent=1.5,
                restitutionCoefficient=1.0 - (1.0 - model.restitution**2) / 2.0,
                minimumImpactVelocity=model.smallest_impact_speed_m_s,
                impactModel=1,
            )
        )

    def _add_sensor(self, what: str) -> int:
        kind = getattr(exudyn.OutputVariableType, what)
        return self.system.AddSensor(SensorNode(nodeNumber=self.slider_node, storeInternal=True, outputVariableType=kind))

    def _settings(self) -> exudyn.SimulationSettings:
        settings = exudyn.SimulationSettings()
        integration = settings.timeIntegration
        integration.endTime = program.TURNS * self.model.turn_s
        integration.numberOfSteps = round(integration.endTime / LARGEST_STEP_S)
        integration.automaticStepSize = True
        integration.absoluteTolerance = ALLOWED_ERROR
        integration.relativeTolerance = ALLOWED_ERROR
        integration.minimumStepSize = SMALLEST_STEP_S
        integration.discontinuous.iterationTolerance = CONTACT_ITERATION_TOLERANCE_N
        integration.explicit.computeEndOfStepAccelerations = False
        integration.verboseMode = 0
        settings.solution.file.write = False
        settings.solution.recordImagesInterval = -1
        settings.solution.sensors.writePeriod = self.model.turn_s / program.READINGS_PER_TURN
        return settings

    def run(self, clearance_m: float) -> np.ndarray:
        """Positions of the slider at the reading times, m."""
        change = self.system.SetObjectParameter
        change(self.contact, "spheresRadii", [self.model.bearing_radius_m - clearance_m, self.model.bearing_radius_m])
        change(self.contact, "contactStiffness", contact_stiffness(self.model, clearance_m))
        self.system.SetNodeParameter(self.gap_node, "initialCoordinates", [clearance_m, 0.0, 0.0, 0.0])
        self.system.Assemble()
        self.system.SolveDynamic(self.settings, solverType=exudyn.DynamicSolverType.DOPRI5)
        return self._readings()

    def _readings(self) -> np.ndarray:
        """The stored rows lie at the ends of steps: cubics through positions and velocities lead to the reading times."""
        positions, velocities = (self.system.GetSensorStoredData(sensor) for sensor in self.sensors)
        times_s, x_m, v_m_s = positions[:, 0], positions[:, 1], velocities[:, 1]
        wanted_s = program.reading_times_s(self.model.turn_s)
        row = np.clip(np.searchsorted(times_s, wanted_s, side="right") - 1, 0, len(times_s) - 2)
        length_s = times_s[row + 1] - times_s[row]
        share = (wanted_s - times_s[row]) / length_s
        chord_m = x_m[row + 1] - x_m[row]
        left_m, right_m = v_m_s[row] * length_s, v_m_s[row + 1] * length_s
        bend = 3.0 * chord_m - 2.0 * left_m - right_m
        return x_m[row] + share * (left_m + share * (bend + share * (left_m + right_m - 2.0 * chord_m)))


if __name__ == "__main__":
    program.main(Simulator(Model.read()).run)
