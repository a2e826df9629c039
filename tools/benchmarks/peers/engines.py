"""The block in programs that simulate rigid bodies in contact, as discrete elements do: MuJoCo and Bullet.

The ground stays and the body force turns: gravity has the reversed acceleration of the ground as its horizontal part,
which is the same motion relative to the ground. Contacts are inelastic, friction keeps the block from sliding.
"""

from __future__ import annotations

import math
from types import ModuleType

import numpy as np
from scipy.constants import g

from records.record import Record
from tools.benchmarks.peers.body import DENSITY, HEIGHT, MASS, WIDTH, Ran, sampled, swings

FRICTION = 3.0
MODEL = """<mujoco>
<option timestep="{step}" gravity="0 0 {gravity}" cone="elliptic" impratio="10" integrator="implicitfast"
 iterations="100" tolerance="1e-12"/>
<default><geom friction="{friction} 0 0" solref="{time} 1" solimp="0.95 0.99 0.0001" condim="3"/></default>
<worldbody><geom type="plane" size="20 20 1"/><body pos="0 0 {half_height}">
<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint type="hinge" axis="0 1 0"/>
<geom type="box" size="{half_width} 0.5 {half_height}" density="{density}"/></body></worldbody></mujoco>"""
"""Contacts as stiff as its documentation allows: a time constant of two steps, critically damped."""


def by_mujoco(mujoco: ModuleType, record: Record, step: float) -> Ran:
    """Rock a box on a plane with three degrees of freedom."""
    text = MODEL.format(step=step, gravity=-g, friction=FRICTION, time=2 * step, half_height=HEIGHT / 2,
                        half_width=WIDTH / 2, density=DENSITY)  # fmt: skip
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    ground = sampled(record, step)
    rotation = np.empty(ground.size)
    for n, acceleration in enumerate(ground.tolist()):
        model.opt.gravity[0] = -acceleration
        mujoco.mj_step(model, data)
        rotation[n] = data.qpos[2]
    return Ran(swings(rotation), rotation.size)


def by_bullet(pybullet: ModuleType, record: Record, step: float) -> Ran:
    """Rock a box on a box in space."""
    world = pybullet.connect(pybullet.DIRECT)
    try:
        pybullet.setTimeStep(step)
        pybullet.setPhysicsEngineParameter(
            numSolverIterations=200, numSubSteps=1, solverResidualThreshold=1e-12,
            contactBreakingThreshold=1e-3, contactSlop=0, restitutionVelocityThreshold=0,
        )  # fmt: skip
        ground = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[20, 20, 1])
        block = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[WIDTH / 2, 0.5, HEIGHT / 2])
        pybullet.createMultiBody(0, ground, basePosition=[0, 0, -1])
        body = pybullet.createMultiBody(MASS, block, basePosition=[0, 0, HEIGHT / 2])
        for each in (0, body):
            pybullet.changeDynamics(
                each, -1, lateralFriction=FRICTION, restitution=0, rollingFriction=0, spinningFriction=0,
                linearDamping=0, angularDamping=0,
            )  # fmt: skip
        samples = sampled(record, step)
        rotation = np.empty(samples.size)
        for n, acceleration in enumerate(samples.tolist()):
            pybullet.setGravity(-acceleration, 0, -g)
            pybullet.stepSimulation()
            turn = pybullet.getBasePositionAndOrientation(body)[1]
            rotation[n] = 2 * math.atan2(turn[1], turn[3])
        return Ran(swings(rotation), rotation.size)
    finally:
        pybullet.disconnect(world)
