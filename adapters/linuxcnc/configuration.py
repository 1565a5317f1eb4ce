# SPDX-License-Identifier: Apache-2.0
"""The files of a start of LinuxCNC: sim.ini and sim.hal for a machine of perfect drives, recorded each period."""
SERVO_PERIOD = 200_000  # ns
VELOCITY = 2000  # mm/s, degrees/s
# The interpolator deviates by acceleration · period² / 6, twice that where it turns round: less with a longer period.
ACCELERATION = 150_000  # mm/s², with SERVO_PERIOD
ROTARY_ACCELERATION = 100_000  # degrees/s²
LIMIT = 1e6
DEPTH = 20_000  # samples
GAIN = 1e6  # the sampler prints six decimals: joints are recorded in millionths


def ini(module, period):
    joints = module.joints
    slower = (SERVO_PERIOD / period) ** 2
    linear, rotary = ACCELERATION * slower, ROTARY_ACCELERATION * slower
    sections = [f"""[EMC]
MACHINE = toolcomp
VERSION = 1.1
[DISPLAY]
DISPLAY = ./ui.py
[RS274NGC]
PARAMETER_FILE = sim.var
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 4
SERVO_PERIOD = {period}
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[HAL]
HALFILE = sim.hal
[TRAJ]
COORDINATES = {joints}
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
MAX_LINEAR_VELOCITY = {VELOCITY}
DEFAULT_LINEAR_VELOCITY = {VELOCITY}
MAX_LINEAR_ACCELERATION = {linear}
DEFAULT_LINEAR_ACCELERATION = {linear}
MAX_ANGULAR_VELOCITY = {VELOCITY}
DEFAULT_ANGULAR_VELOCITY = {VELOCITY}
MAX_ANGULAR_ACCELERATION = {rotary}
DEFAULT_ANGULAR_ACCELERATION = {rotary}
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.005
TOOL_TABLE = sim.tbl
[KINS]
KINEMATICS = {module.name}
JOINTS = {len(joints)}
"""]
    for i, letter in enumerate(joints):
        kind, acceleration = ("ANGULAR", rotary) if letter in "ABC" else ("LINEAR", linear)
        limits = (f"MIN_LIMIT = {-LIMIT:.0f}\nMAX_LIMIT = {LIMIT:.0f}\nMAX_VELOCITY = {VELOCITY}\n"
                  f"MAX_ACCELERATION = {acceleration}\n")
        sections.append(f"[AXIS_{letter}]\n{limits}")
        # Homed where it stands. A pin that changes between programs lets joints jump: no following error for that.
        sections.append(f"[JOINT_{i}]\nTYPE = {kind}\n{limits}FERROR = {LIMIT:.0f}\nMIN_FERROR = {LIMIT:.0f}\n"
                        "HOME = 0\nHOME_OFFSET = 0\nHOME_SEARCH_VEL = 0\nHOME_LATCH_VEL = 0\nHOME_SEQUENCE = 0\n")
    return "".join(sections)


def hal(module):
    joints = range(len(module.joints))
    count = len(module.joints)
    lines = ["loadrt [KINS]KINEMATICS",
             "loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS",
             f"loadrt sampler depth={DEPTH} cfg={'f' * count}ss",
             f"loadrt scale count={count}",
             "addf motion-command-handler servo-thread",
             "addf motion-controller servo-thread"]
    lines += [f"addf scale.{i} servo-thread" for i in joints]
    lines += ["addf sampler.0 servo-thread"]
    for i in joints:
        lines += [f"setp scale.{i}.gain {GAIN:.0f}",
                  f"net joint{i} joint.{i}.motor-pos-cmd => joint.{i}.motor-pos-fb scale.{i}.in",
                  f"net scaled{i} scale.{i}.out => sampler.0.pin.{i}"]
    lines += [f"net line motion.program-line => sampler.0.pin.{count}",
              "setp sampler.0.enable 0",
              "net enable iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in",
              "net change iocontrol.0.tool-change => iocontrol.0.tool-changed",
              "net prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared"]
    if module.length_pin:
        lines.append(f"net length motion.tooloffset.z => {module.length_pin}")
    if module.switch:
        lines.append(f"setp motion.switchkins-type {module.switch}")
    lines.append("loadusr halsampler -c 0 -t trace.txt")
    return "\n".join(lines) + "\n"


def write(folder, module, period):
    (folder / "sim.ini").write_text(ini(module, period))
    (folder / "sim.hal").write_text(hal(module))
    (folder / "sim.tbl").write_text("")
    (folder / "sim.var").write_text("")
