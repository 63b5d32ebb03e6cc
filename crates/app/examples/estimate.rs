//! The same estimate twice: from a request in Rust, and from one in JSON.

use soilctl_app::request::{NumberOrColumn, from_json};
use soilctl_app::{AppError, Unwatched, document, estimate};

fn main() -> Result<(), AppError> {
    let request = estimate::Request {
        file: "data/soils/ticino_rained/strokes.csv".into(),
        model: "chen".into(),
        delta_deg: NumberOrColumn::Number(23.0),
        ..estimate::Request::default()
    };
    let found = estimate::run(&request, &Unwatched)?;
    let text = r#"{"file": "data/soils/ticino_rained/strokes.csv", "model": "chen", "delta_deg": 23, "delta_tol_deg": 1}"#;
    let same = estimate::run(&from_json(text)?, &Unwatched)?;
    let is_same = document(&found.answer)? == document(&same.answer)?;
    #[allow(clippy::print_stdout, reason = "an example")]
    {
        println!("{}\nthe same from JSON: {is_same}", found.answer.verdict);
    }
    Ok(())
}
