//! Writes one figure of each kind, a grid and a report to the directory given as argument.

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use soilctl_figure::{
    Align, Axis, Band, CalloutKind, Figure, FigureGrid, HtmlReport, Legend, Line, Points, Polygon, Polygons,
    RefLine, RichText, Size, Span, Table, Text, TextPlace,
};

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let directory = PathBuf::from(std::env::args_os().nth(1).ok_or("usage: gallery DIRECTORY")?);
    fs::create_dir_all(&directory)?;
    let figures = [
        ("shear", shear()?),
        ("envelope", envelope()?),
        ("regions", regions()?),
        ("relaxation", relaxation()?),
        ("palette", palette()?),
    ];
    for (name, figure) in &figures {
        fs::write(directory.join(format!("{name}.svg")), figure.to_svg(Size::default())?)?;
        fs::write(directory.join(format!("{name}.png")), figure.to_png(Size::default())?)?;
        fs::write(directory.join(format!("{name}.csv")), figure.to_csv())?;
    }
    let grid = FigureGrid::new(figures.clone().map(|(_, figure)| figure), 2)?;
    let page = Size::new(1200, 1200)?;
    fs::write(directory.join("grid.svg"), grid.to_svg(page)?)?;
    fs::write(directory.join("grid.png"), grid.to_png(page)?)?;
    fs::write(directory.join("report.html"), report(&figures.map(|(_, figure)| figure))?)?;
    Ok(())
}

fn shear() -> Outcome<Figure> {
    let stress =
        |u: f64, peak: f64| peak * (u / 2.0) * (1.0 - u / 2.0).exp() * 0.4 + 0.6 * peak * (1.0 - (-u).exp());
    let displacements: Vec<f64> = (0..=120).map(|i| f64::from(i) * 0.1).collect();
    let curve = |peak: f64| displacements.iter().map(|&u| (u, stress(u, peak))).collect::<Vec<_>>();
    let mut figure = Figure::new(
        "Shear stress against shear displacement at three normal stresses",
        Axis::linear("Shear displacement (mm)"),
        Axis::linear("Shear stress τ (kPa)"),
    );
    for (i, (load, peak)) in [(50, 41.0), (100, 78.0), (200, 149.0)].into_iter().enumerate() {
        let scaled =
            |factor: f64| displacements.iter().map(|&u| factor * stress(u, peak)).collect::<Vec<_>>();
        figure.push(Band::new("", displacements.clone(), scaled(0.95), scaled(1.05)).color(i))?;
        figure.push(Line::new(format!("simulated, σₙ = {load} kPa"), curve(peak)).color(i))?;
    }
    let measured: Vec<(f64, f64)> =
        (1..12).map(|u| (f64::from(u), 0.98 * stress(f64::from(u), 149.0))).collect();
    let errors = vec![(4.0, 6.0); measured.len()];
    let labels = (1..12).map(|i| format!("reading {i}"));
    figure.push(Points::new("measured, σₙ = 200 kPa", measured).color(2).y_error(errors).labels(labels))?;
    figure.push(RefLine::vertical("end of shearing", 11.5))?;
    figure.push(Text::new("peak", (2.0, stress(2.0, 149.0) * 1.05)))?;
    Ok(figure)
}

fn envelope() -> Outcome<Figure> {
    let mut figure = Figure::new(
        "Failure envelope",
        Axis::linear("Normal stress σ (kPa)"),
        Axis::linear("Shear stress τ (kPa)"),
    )
    .with_equal_aspect()?
    .with_legend(Legend::Right);
    figure.push(Line::new("c = 4.1 kPa, φ = 35.9°", [(0.0, 4.1), (260.0, 4.1 + 260.0 * 0.724)]))?;
    let circle = |center: f64, radius: f64| {
        (0..=60)
            .map(|i| f64::from(i) * std::f64::consts::PI / 60.0)
            .map(|a| (center + radius * a.cos(), radius * a.sin()))
            .collect::<Vec<_>>()
    };
    figure.push(Line::new("Mohr circle", circle(160.0, 97.0)))?;
    figure.push(Points::new("peak states", [(50.0, 41.0), (100.0, 78.0), (200.0, 149.0)]))?;
    figure.push(Text::new("test 3", (200.0, 149.0)).place(TextPlace::Left))?;
    Ok(figure)
}

fn regions() -> Outcome<Figure> {
    let mut figure = Figure::new(
        "Admissible parameters <script>alert(1)</script> & others",
        Axis::linear("Friction coefficient μ (–)").range(0.0, 1.0)?,
        Axis::linear("Rolling resistance μᵣ (–)"),
    );
    let ring = |x: f64, y: f64, r: f64| {
        (0..40)
            .map(|i| f64::from(i) * std::f64::consts::TAU / 40.0)
            .map(|a| (x + r * a.cos(), y + 0.5 * r * a.sin()))
            .collect::<Vec<_>>()
    };
    figure.push(Span::horizontal("measured density ± 4 %", 0.28, 0.36))?;
    figure.push(Span::vertical("literature values", 0.55, 0.7).color(5))?;
    figure.push(Polygons::new(
        "within tolerance of all tests",
        [Polygon::new(ring(0.4, 0.3, 0.25)).hole(ring(0.4, 0.3, 0.1)), Polygon::new(ring(0.85, 0.4, 0.2))],
    ))?;
    figure.push(Polygons::new("one test only", [Polygon::new(ring(0.3, 0.15, 0.2))]))?;
    figure.push(Points::new("best", [(0.45, 0.22)]).color(6))?;
    figure.push(RefLine::horizontal("upper bound", 0.48))?;
    figure.push(Text::new("best: μ = 0.45", (0.45, 0.22)).place(TextPlace::Right))?;
    Ok(figure)
}

fn relaxation() -> Outcome<Figure> {
    let mut figure =
        Figure::new("Creep on logarithmic axes", Axis::log("Time t (s)"), Axis::log("Strain rate (1/s)"));
    let decay = |rate: f64| {
        (0..=40).map(|i| 10f64.powf(f64::from(i) * 0.125)).map(move |t| (t, rate / t)).collect::<Vec<_>>()
    };
    figure.push(Line::new("25 kPa", decay(1e-4)))?;
    figure.push(Line::new("50 kPa", decay(4e-4)))?;
    figure.push(Span::vertical("loading", 2.0, 8.0))?;
    figure.push(RefLine::horizontal("resolution", 2e-8))?;
    figure.push(Points::new("measured", [(10.0, 3.2e-5), (100.0, 4.4e-6), (1e4, 3.7e-8)]).y_error([
        (1e-5, 2e-5),
        (1e-6, 1e-6),
        (1e-8, 2e-8),
    ]))?;
    figure.push(Text::new("slope −1", (1000.0, 4e-7)).place(TextPlace::Right))?;
    Ok(figure)
}

fn palette() -> Outcome<Figure> {
    let mut figure = Figure::new("All palette entries", Axis::linear("x (m)"), Axis::linear("y (m)"))
        .with_legend(Legend::Right);
    for i in 0..8 {
        let y = f64::from(i);
        figure
            .push(Line::new(format!("line {i}"), [(0.0, y), (4.0, y + 0.4), (8.0, y)]).color(i as usize))?;
        figure.push(Points::new(format!("points {i}"), [(9.0, y), (9.5, y + 0.2)]).color(i as usize))?;
    }
    Ok(figure)
}

fn report(figures: &[Figure]) -> Outcome<String> {
    let mut report = HtmlReport::new("Calibration <script>alert(1)</script> & check");
    report.subtitle("Sample S1, dense sand").heading("Summary").paragraph(
        RichText::new("The parameters reproduce ")
            .strong("three of three")
            .text(" tests; the data are in ")
            .code("s1 <raw>.csv")
            .text(" and ")
            .emphasis("were not smoothed")
            .text("."),
    );
    report.callout(CalloutKind::Good, "Within tolerance", "All peak stresses deviate by less than 4 %.");
    report.callout(CalloutKind::Bad, "Density not met", "The simulated density is 6 % too low.");
    report.callout(CalloutKind::Warning, "Few tests", "Three tests do not tell cohesion from friction well.");
    report.callout(CalloutKind::Note, "Units", "Stresses are in kPa.");
    let mut table = Table::new(
        "Peak states",
        [
            ("Test", Align::Left),
            ("σₙ (kPa)", Align::Right),
            ("τ (kPa)", Align::Right),
            ("Met", Align::Center),
        ],
    );
    table
        .row(["S1-a", "50", "41.0", "✓"])?
        .row(["S1-b", "100", "78.0", "✓"])?
        .row(["S1-c", "200", "149.0", "✓"])?;
    report.table(table).heading("Figures");
    for figure in figures {
        report.figure(
            figure,
            Size::default(),
            RichText::new("How ").emphasis("this").text(" was obtained is described in the manual."),
        )?;
    }
    report.subheading("Settings").definitions([
        ("Seed", "42"),
        ("Particles", "12 000"),
        ("Time step", "1.5 µs"),
    ]);
    report.footer("soilctl 0.1.0");
    Ok(report.to_html())
}
