//! What the viewer shows where: arm and forces at the left with states and events below, curves at the right.

use crate::rows::texts;
use crate::rrd::{Column, Component, Values};

/// A part of the window; containers have shares of their parts.
enum Part {
    View { class: &'static str, name: &'static str, origin: &'static str },
    Row(Vec<(Part, f32)>),
    Column(Vec<(Part, f32)>),
    Tabs(Vec<Part>),
}

const fn view(class: &'static str, name: &'static str, origin: &'static str) -> Part {
    Part::View { class, name, origin }
}

fn own() -> Part {
    let curves = |name, origin| view("TimeSeries", name, origin);
    let texts = Part::Tabs(vec![
        view("TextLog", "Events", "/events"),
        view("TextDocument", "About this log", "/about"),
    ]);
    let states = view("StateTimeline", "State", "/state");
    let scene =
        Part::Column(vec![(view("3D", "Arm and forces", "/world"), 4.0), (states, 1.3), (texts, 1.3)]);
    let joints = Part::Tabs(vec![
        curves("Joints (deg)", "/joints/position"),
        curves("Joint torques (N m)", "/joints/torque"),
        curves("Force sensor (N)", "/force_sensor"),
    ]);
    let right = Part::Column(vec![
        (curves("Force on the plate (N)", "/force"), 3.0),
        (curves("Friction angle (deg)", "/friction_angle"), 2.0),
        (curves("Displacement and lead (mm)", "/displacement"), 2.0),
        (curves("Height and depth (mm)", "/height"), 2.0),
        (joints, 2.0),
    ]);
    Part::Row(vec![(scene, 3.0), (right, 2.0)])
}

/// Of a recording of another program.
fn foreign() -> Part {
    let curves = |name, origin| view("TimeSeries", name, origin);
    let about = view("TextDocument", "About this log", "/about");
    let scene = Part::Column(vec![(view("3D", "Arm and force", "/world"), 4.0), (about, 1.3)]);
    let joints = Part::Tabs(vec![
        curves("Joints that turn (deg)", "/joints/turning"),
        curves("Joints that slide (mm)", "/joints/sliding"),
    ]);
    let right = Part::Column(vec![
        (curves("Force as read (N)", "/force_sensor"), 3.0),
        (curves("Torque as read (N m)", "/torque_sensor"), 2.0),
        (curves("End-point (m)", "/end_point"), 2.0),
        (joints, 2.0),
    ]);
    Part::Row(vec![(scene, 3.0), (right, 2.0)])
}

/// The layout as entities; of a log of ours, or of another program's recording.
pub(crate) fn layout(of_ours: bool) -> Vec<(String, Vec<Column>)> {
    const ROOT: Component = Component::layout("ViewportBlueprint", "root_container", "RootContainer");
    const OWN_LAYOUT: Component = Component::layout("ViewportBlueprint", "auto_layout", "AutoLayout");
    const OWN_VIEWS: Component = Component::layout("ViewportBlueprint", "auto_views", "AutoViews");
    const TIME_STATE: Component = Component::layout("TimePanelBlueprint", "state", "PanelState");
    const TIMELINE: Component = Component::layout("TimePanelBlueprint", "timeline", "TimelineName");
    const PANEL_STATE: Component = Component::layout("PanelBlueprint", "state", "PanelState");
    const HIDDEN: u8 = 1;
    const COLLAPSED: u8 = 2;
    let mut made = Made::default();
    let (_, root) = made.part(if of_ours { own() } else { foreign() });
    let state = |component, state| Column::row(component, Values::Bytes(vec![state]));
    let flag = |component| Column::row(component, Values::Flags(vec![false]));
    made.put(
        "/viewport".to_owned(),
        vec![Column::row(ROOT, Values::Ids(vec![root])), flag(OWN_LAYOUT), flag(OWN_VIEWS)],
    );
    let timeline = Column::row(TIMELINE, texts(["time"]));
    made.put("/time_panel".to_owned(), vec![state(TIME_STATE, COLLAPSED), timeline]);
    made.put("/blueprint_panel".to_owned(), vec![state(PANEL_STATE, COLLAPSED)]);
    made.put("/selection_panel".to_owned(), vec![state(PANEL_STATE, HIDDEN)]);
    made.entities
}

#[derive(Default)]
struct Made {
    entities: Vec<(String, Vec<Column>)>,
    last: u8,
}

impl Made {
    fn put(&mut self, entity: String, columns: Vec<Column>) {
        self.entities.push((entity, columns));
    }

    /// Makes a part and those in it; its entity without the leading slash, and its id.
    fn part(&mut self, part: Part) -> (String, [u8; 16]) {
        match part {
            Part::View { class, name, origin } => self.view(class, name, origin),
            Part::Row(parts) => self.container(2, "col_shares", "ColumnShare", parts),
            Part::Column(parts) => self.container(3, "row_shares", "RowShare", parts),
            Part::Tabs(parts) => {
                let parts = parts.into_iter().map(|part| (part, 1.0)).collect();
                self.container(1, "col_shares", "ColumnShare", parts)
            }
        }
    }

    fn view(&mut self, class: &str, name: &str, origin: &str) -> (String, [u8; 16]) {
        const CLASS: Component = Component::layout("ViewBlueprint", "class_identifier", "ViewClass");
        const NAME: Component = Component::layout_name("ViewBlueprint", "display_name");
        const ORIGIN: Component = Component::layout("ViewBlueprint", "space_origin", "ViewOrigin");
        const QUERY: Component = Component::layout("ViewContents", "query", "QueryExpression");
        const LEGEND: Component = Component::layout("PlotLegend", "corner", "Corner2D");
        const RIGHT_TOP: u8 = 2;
        let (path, id) = self.named("view");
        let columns =
            [(CLASS, class), (NAME, name), (ORIGIN, origin)].map(|(c, text)| Column::row(c, texts([text])));
        self.put(format!("/{path}"), columns.into());
        let all = Column::row(QUERY, texts(["+ $origin/**"]));
        self.put(format!("/{path}/ViewContents"), vec![all]);
        if class == "TimeSeries" {
            // While a log is played nothing is drawn there yet.
            let corner = Column::row(LEGEND, Values::Bytes(vec![RIGHT_TOP]));
            self.put(format!("/{path}/PlotLegend"), vec![corner]);
        }
        (path, id)
    }

    fn container(
        &mut self,
        kind: u8,
        field: &'static str,
        share: &'static str,
        parts: Vec<(Part, f32)>,
    ) -> (String, [u8; 16]) {
        const KIND: Component = Component::layout("ContainerBlueprint", "container_kind", "ContainerKind");
        const CONTENTS: Component = Component::layout("ContainerBlueprint", "contents", "IncludedContent");
        let (path, id) = self.named("container");
        let shares = parts.iter().map(|(_, share)| *share).collect();
        let inner: Vec<String> = parts.into_iter().map(|(part, _)| self.part(part).0).collect();
        let columns = vec![
            Column::row(KIND, Values::Bytes(vec![kind])),
            Column::row(CONTENTS, texts(inner.iter().map(String::as_str))),
            Column::row(Component::layout("ContainerBlueprint", field, share), Values::Single(shares)),
        ];
        self.put(format!("/{path}"), columns);
        (path, id)
    }

    /// Ids count; they have the form of a random UUID (version 4), since that is how the viewer makes them.
    fn named(&mut self, kind: &str) -> (String, [u8; 16]) {
        self.last += 1;
        let mut id = [0; 16];
        (id[6], id[8], id[15]) = (0x40, 0x80, self.last);
        (format!("{kind}/00000000-0000-4000-8000-{:012x}", self.last), id)
    }
}
