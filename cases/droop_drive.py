# SPDX-License-Identifier: GPL-3.0-or-later
"""A drivetrain of another program in the loop: the quickstart's motor, gear and inertia in Python.

    pip install pythonfmu
    pythonfmu build -f cases/droop_drive.py --handle-state --serialize-state        # makes DroopDrive.fmu
    LD_PRELOAD=libpython3.11.so.1.0 gyrosim run cases/quickstart.yaml --set 'drivetrain={fmu: /full/path/DroopDrive.fmu}'

The preloaded library is that of the Python for which pythonfmu was installed. What is exchanged: mbd/fmi/README.md.
"""
from math import pi

from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Integer, Real


class DroopDrive(Fmi2Slave):
    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.synchronous_speed = 1697 * 2 * pi / 60  # of the motor [rad/s]
        self.stall_torque = 6.25  # of the motor [N m]
        self.gear_ratio = 3.75
        self.inertia = 0.1526 + 3.75**2 * 1.526e-3  # at the eccentric [kg m2]
        self.parts = 10  # Euler's steps in one of the master's
        self.mantle_torque = 0.0  # of the rock at the eccentric, positive when it resists [N m]
        self.eccentric_speed = self.synchronous_speed / self.gear_ratio
        self.eccentric_angle = 0.0
        self.motor_torque = 0.0
        told = {"causality": Fmi2Causality.parameter, "variability": Fmi2Variability.tunable}
        for name in ("synchronous_speed", "stall_torque", "gear_ratio", "inertia"):
            self.register_variable(Real(name, **told))
        self.register_variable(Integer("parts", **told))
        self.register_variable(Real("mantle_torque", causality=Fmi2Causality.input))
        for name in ("eccentric_speed", "eccentric_angle", "motor_torque"):
            self.register_variable(Real(name, causality=Fmi2Causality.output))

    def do_step(self, current_time, step_size):
        dt = step_size / self.parts
        for _ in range(self.parts):
            share = self.gear_ratio * self.eccentric_speed / self.synchronous_speed
            self.motor_torque = self.stall_torque * (1 - share)
            self.eccentric_angle += dt * self.eccentric_speed
            self.eccentric_speed += dt * (self.gear_ratio * self.motor_torque - self.mantle_torque) / self.inertia
        return True
