//! What the steps of the tables do on entering and on leaving.

use soilctl_kinematics::TaskPose;

use super::Action;
use crate::estimate::Estimate;
use crate::events::EventKind;
use crate::{Events, Finish, Params, State, StrokeSpec, Trajectory};

/// Directions of the walls along x and y.
const WALLS: [[f64; 3]; 4] = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];

/// Queues a trajectory; a full ring counts as a failure of the step.
fn queue(state: &mut State, trajectory: Trajectory) {
    if state.ring.push(trajectory) {
        state.idle = false;
    } else {
        state.ring.clear();
        state.last_finish = Some(Finish::Aborted);
    }
}

pub(super) fn enter(state: &mut State, params: &Params, est: &Estimate, action: Action) {
    let config = params.config();
    match action {
        // `leave` of a called sequence's caller has nothing to do here either.
        Action::Wait | Action::Call(_) => {}
        Action::TouchStop(joint) => queue(state, Trajectory::JointTouch { joint }),
        Action::SetHome => {
            state.pending_home = true;
            queue(state, Trajectory::Hold { ticks: Some(2) });
        }
        Action::Park => queue(state, Trajectory::JointMove { target: params.park }),
        Action::Bias => {
            // The readings begin with the next tick.
            state.filters.start_bias(params);
            queue(state, Trajectory::Hold { ticks: Some(config.force_sensor.bias_ticks + 1) });
        }
        Action::TouchSoil => {
            let travel_m = config.touch.soil_travel_m;
            queue(state, Trajectory::CartesianTouch { direction: [0.0, 0.0, -1.0], travel_m });
        }
        Action::Insert => {
            // What the touch has already pushed in counts.
            let depth_m = (state.machine.stroke.depth_m - (state.surface_z_m - est.pose.z_m)).max(1e-4);
            queue(state, Trajectory::Insert { depth_m });
        }
        Action::Stroke => {
            let (law, delta_rad) = (state.tuning.law, state.machine.stroke.delta_rad);
            queue(state, Trajectory::Stroke { law, delta_rad });
        }
        Action::PullOut => {
            let z_m = (state.surface_z_m + config.site.transit_m).max(est.pose.z_m);
            queue(state, Trajectory::CartesianMove { target: TaskPose { z_m, n2_rad: 0.0, ..est.pose } });
        }
        Action::Remember => state.machine.remembered = est.pose,
        Action::TouchWall(wall) => {
            let direction = WALLS[usize::from(wall) % WALLS.len()];
            queue(state, Trajectory::CartesianTouch { direction, travel_m: config.touch.wall_travel_m });
        }
        Action::Return => queue(state, Trajectory::CartesianMove { target: state.machine.remembered }),
        Action::PlanFirst => {
            let first = params.plan().strokes().get(usize::from(state.machine.index)).copied();
            take(state, first);
            // The operator has prepared the soil for the stroke at which the campaign begins.
            state.machine.batch = state.machine.stroke.batch;
        }
        Action::PlanNext => {
            state.machine.batch = state.machine.stroke.batch;
            state.machine.index = state.machine.index.saturating_add(1);
            let next = params.plan().strokes().get(usize::from(state.machine.index)).copied();
            take(state, next);
        }
        Action::SweepFirst => {
            state.machine.index = 0;
            take(state, sweep_stroke(params, 0));
            state.machine.batch = state.machine.stroke.batch;
        }
        Action::SweepNext => {
            state.machine.batch = state.machine.stroke.batch;
            state.machine.index = state.machine.index.saturating_add(1);
            take(state, sweep_stroke(params, state.machine.index));
        }
        Action::GoToStroke => {
            let surface = config.site.surface_z_m;
            let stroke = state.machine.stroke;
            let transit = surface + config.site.transit_m;
            if est.pose.z_m < transit {
                queue(state, Trajectory::CartesianMove { target: TaskPose { z_m: transit, ..est.pose } });
            }
            // Joints, since from the parking posture a straight line may lead through the arm.
            if let Ok(target) = params.arm().inverse(&stroke.pose(transit)) {
                queue(state, Trajectory::JointMove { target });
            }
            let target = stroke.pose(surface + config.site.clearance_m);
            queue(state, Trajectory::CartesianMove { target });
        }
    }
}

fn take(state: &mut State, stroke: Option<StrokeSpec>) {
    state.machine.stroke_left = stroke.is_some();
    if let Some(stroke) = stroke {
        state.machine.stroke = stroke;
    }
}

/// The stroke of this number in the friction sweep; a batch is as many as the base angles.
pub(super) fn sweep_stroke(params: &Params, index: u16) -> Option<StrokeSpec> {
    let sweep = &params.config().sweep;
    let delta_deg = sweep.first_delta_deg + f64::from(index) * sweep.step_deg;
    if delta_deg > sweep.last_delta_deg + 1e-9 {
        return None;
    }
    let places = sweep.base_deg.len().max(1);
    let base_deg = sweep.base_deg.get(usize::from(index) % places)?;
    Some(StrokeSpec {
        batch: u16::try_from(usize::from(index) / places).unwrap_or(u16::MAX),
        radius_m: sweep.radius_m,
        base_rad: base_deg.to_radians(),
        tool_angle_rad: sweep.tool_angle_deg.to_radians(),
        depth_m: sweep.depth_m,
        delta_rad: delta_deg.to_radians(),
    })
}

/// Notes what a step has found.
pub(super) fn leave(state: &mut State, est: &Estimate, params: &Params, action: Action, events: &mut Events) {
    let contact = state.last_finish == Some(Finish::Contact);
    match action {
        Action::TouchSoil if contact => {
            state.surface_z_m = state.touched_m[2];
            events.push(EventKind::SurfaceFound, 0, state.surface_z_m, 0.0);
        }
        Action::TouchWall(wall) if contact => {
            let place = usize::from(wall) % WALLS.len();
            let found = state.touched_m[usize::from(place >= 2)];
            state.walls_m[place] = Some(found);
            events.push(EventKind::WallFound, place, found, 0.0);
        }
        Action::Insert => {
            let depth = state.surface_z_m - est.pose.z_m;
            events.push(EventKind::Inserted, 0, depth, state.machine.stroke.depth_m);
        }
        Action::Stroke => {
            let run = &state.last_stroke;
            let index = usize::from(state.machine.index);
            events.push(EventKind::StrokeEnded, index, run.peak_force_n, run.lead_m);
            let limit = params.config().stroke.lift_deg;
            events.push(EventKind::Lift, index, run.lift_rad.to_degrees(), limit);
            events.push(EventKind::Rise, index, run.rise_m, params.config().stroke.lift_rise_m);
        }
        _ => {}
    }
}
