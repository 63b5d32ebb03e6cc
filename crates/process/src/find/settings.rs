/// What a contact and a stroke are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FindSettings {
    /// Wrench in free air, in N and N m in the sensor frame; `None` to take it from free air before each contact, with
    /// which a log then has to begin.
    pub tare: Option<[f64; 6]>,
    /// Contact begins above this force in N...
    pub on_n: f64,
    /// ...and ends below this one, which is lower.
    pub off_n: f64,
    /// The force must stay below for so long, in s; free air afterwards is read in this time.
    pub quiet_s: f64,
    /// Free air kept before a contact, in s: the tare is its mean.
    pub air_s: f64,
    /// Left out of free air next to a contact, in s.
    pub margin_s: f64,
    /// Samples further apart end a contact, in s.
    pub most_gap_s: f64,
    /// A contact is cut after this time, in s.
    pub longest_s: f64,
    /// A stroke travels at least so far along the ground, in m.
    pub least_travel_m: f64,
    /// The plate is inserted while it is more than this above its lowest, in m.
    pub lowest_m: f64,
    /// The plate is pulled out when it is more than this above its lowest, in m.
    pub out_m: f64,
}

impl Default for FindSettings {
    fn default() -> Self {
        Self {
            tare: None,
            on_n: 0.3,
            off_n: 0.15,
            quiet_s: 0.6,
            air_s: 2.0,
            margin_s: 0.2,
            most_gap_s: 1.0,
            longest_s: 300.0,
            least_travel_m: 1.5e-3,
            lowest_m: 2.0e-3,
            out_m: 8.0e-3,
        }
    }
}
