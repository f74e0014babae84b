/// Shown under `cogmap run --help`.
pub(super) const RUN: &str = "\
Example: cogmap run worlds/small-office.world.json --out first-run
Example: cogmap run worlds/small-office.world.json --robot good --seed 7 --route random
Example: cogmap run worlds/small-office.world.json --mapper perceptual --mapper odometry --out both
Example: cogmap run worlds/office.world.json --go-home --strategy retrace --out home
Example: cogmap run generated:7 --go-home --out floor-7
Example: cogmap run plan.png --resolution 0.05 --route random --out plan

In a floor plan everything that is not free is solid, and the robot starts where there is most room.
The person who drives sees the true building; the mappers see only the laser and the wheels.
With --go-home the run has failed unless the robot stops within 1.5 m of its start and has hit nothing.
A robot FILE is a JSON file; `--out` leaves one in session.json, under \"robot\".";

/// Shown under `cogmap replay --help`.
pub(super) const REPLAY: &str = "\
Example: cogmap replay intel.log.gz --out intel
Example: cogmap replay intel.log.gz --every 0.5 --odometry-noise 3 --seed 2 --out noisy
Example: cogmap replay intel/session.json --out again

A session gives every file but timing.json again, byte for byte. It finds its log by the path
that it was given, or beside itself, and makes sure that it is the very same log.";

/// Shown under `cogmap figures --help`.
pub(super) const FIGURES: &str = "\
Example: cogmap figures
Example: cogmap figures 3.8 3.9 --seed 7 --out other-drives
Example: cogmap figures --list

None is a copy: each is a new run that shows what the figure of that number shows, and says so.";

/// Shown under `cogmap check --help`.
pub(super) const CHECK: &str = "\
Example: cogmap check worlds/*.world.json
Example: cogmap check intel.log.gz first-run/session.json
Example: cogmap check hall.yaml

Exit code 2 if anything is wrong with any of the files.";
