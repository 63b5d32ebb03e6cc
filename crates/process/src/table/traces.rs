use std::io::Write;

use crate::log::LogStroke;

/// Header of `traces.csv`.
pub const TRACES_HEADER: &str = "stroke_id,t_s,x_ext_m,x_mtr_m,force_n,friction_angle_deg,z_m\n";

/// Writes a stroke's trace as lines of `traces.csv`, at most `rate_hz` samples a second, each as it was recorded.
///
/// Displacements are those of the two encoders without any compensation, so that stretch and free play can be seen; a
/// bag has only one, which then stands under `x_ext_m`.
///
/// # Errors
/// Whatever the writer says.
pub fn write_trace(
    stroke: &LogStroke,
    stroke_id: &str,
    rate_hz: f64,
    output: &mut dyn Write,
) -> std::io::Result<()> {
    let trace = &stroke.evaluated.trace;
    let name = quoted(stroke_id);
    let mut next_s = f64::NEG_INFINITY;
    for (i, &t_s) in trace.t_s().iter().enumerate() {
        // Half a microsecond for what the sum of many steps is off.
        if t_s < next_s - 5e-7 {
            continue;
        }
        next_s = t_s.max(next_s) + 1.0 / rate_hz;
        let cell = |values: Option<&Vec<f64>>| values.map(|v| v[i].to_string()).unwrap_or_default();
        let (external, motor) = match &stroke.course {
            Some(course) => (course.external_m[i].to_string(), course.motor_m[i].to_string()),
            None => (trace.displacement_m()[i].to_string(), String::new()),
        };
        let angle = cell(trace.channels().friction_angle_deg.as_ref());
        let z = cell(trace.channels().z_m.as_ref());
        writeln!(output, "{name},{t_s},{external},{motor},{},{angle},{z}", trace.force_n()[i])?;
    }
    Ok(())
}

/// A cell of CSV, in quotes where it needs them.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
