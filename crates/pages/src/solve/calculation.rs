//! What makes a page of bounds a calculation for an engineer's file: assumptions, limits, the certificate, and who answers for it.

use std::path::Path;

use soilctl_app::AppError;
use soilctl_app::solve::{Asked, Solved};
use soilctl_figure::{CalloutKind, HtmlReport, RichText};
use soilctl_jobs::sha256;

use crate::PageError;

/// Adds these sections.
pub(super) fn add(page: &mut HtmlReport, found: &Solved, file: &Path) -> Result<(), PageError> {
    page.heading("Assumptions and limits").definitions(assumptions(found));
    for note in &found.answer.notes {
        page.callout(CalloutKind::Warning, "An unusual value", note.as_str());
    }
    page.heading("Certificate");
    certificate(page, found, file)?;
    page.heading("For the file").to_fill_in([
        "Project",
        "Section, stage of construction",
        "Source of strengths and levels",
        "Prepared by, date",
        "Checked by, date",
        "Approved by, date",
    ]);
    Ok(())
}

/// What was assumed of this problem, and what the bounds do not tell.
fn assumptions(found: &Solved) -> Vec<(&'static str, String)> {
    let description = &found.description;
    let soils = &description.soils;
    let is_frictional = soils.iter().any(|soil| soil.friction_deg() > 0.0);
    let is_undrained = soils.iter().any(|soil| soil.phi_deg == Some(0.0));
    let mut all = vec![
        ("Plane strain", "the section and all that acts on it go on for ever at right angles to it, and values are per metre of \
                          that direction".to_owned()),
        ("Strength", "Mohr-Coulomb, rigid until it yields and perfectly plastic then: soil neither hardens nor softens, and no \
                      displacements are computed".to_owned()),
        ("Flow", if is_frictional {
            "associated: soil with a friction angle dilates by it when it shears. Real soil dilates less, and where it is closely \
             confined it may bear less than both bounds".to_owned()
        } else {
            "associated: soil without a friction angle keeps its volume".to_owned()
        }),
    ];
    if is_undrained {
        all.push((
            "Soil without friction",
            "its cohesion is its undrained shear strength, and total stresses count".to_owned(),
        ));
    }
    all.push(("Water", match &description.water {
        Some(_) => "at rest below the given table, no suction above it; pore pressures do not change as the soil fails".to_owned(),
        None if !description.heads.is_empty() => {
            "flows steadily between the given heads, by Darcy's law; pore pressures are linear in the triangles of its mesh, no suction above \
             its phreatic surface, and do not change as the soil fails".to_owned()
        }
        None if soils.iter().any(|soil| soil.pore_pressure_ratio != 0.0) => {
            "pore pressures are the given part of the weight above".to_owned()
        }
        None => "none: pore pressures are zero".to_owned(),
    }));
    all.push(("Structures", "rigid; what they bear themselves is not examined".to_owned()));
    if !description.members.is_empty() {
        all.push(("Bars and sheets", "bear forces along themselves alone, up to the given strengths, which are design values: no factor divides \
                                      them".to_owned()));
    }
    if description.members.iter().any(|member| member.pullout_kn_per_m2.is_some()) {
        all.push(("Bars in rows", "smeared over their spacing: the soil goes on between them, and hands them no more than the given pullout resistance, \
                                   whatever the stress on them is; their bending and shearing off is not examined".to_owned()));
    }
    all.push(("Safety", match (found.cases.is_empty(), found.answer.quantity) {
        (false, _) => "partial factors are those of the load cases above, and no others".to_owned(),
        (true, Asked::FactorOfSafety) => {
            let bars = description.members.iter().any(|member| member.pullout_kn_per_m2.is_some());
            let pullout = if bars { ", and the pullout resistance of bars" } else { "" };
            format!("the factor divides cohesion and the tangent of the friction angle{pullout}; no partial factors were applied")
        }
        (true, Asked::ForceKnPerM | Asked::LoadFactor | Asked::WeightFactor | Asked::AccelerationOverG) => {
            "values are as given; no partial factors were applied".to_owned()
        }
    }));
    all.push(("What is proven", "that the true collapse value of this idealised problem is not outside the bounds. Whether the \
                                 problem is the ground's, strengths and levels among it, is for the engineer to judge".to_owned()));
    all
}

/// The files that prove the bounds, by their hashes.
fn certificate(page: &mut HtmlReport, found: &Solved, file: &Path) -> Result<(), PageError> {
    let mut hashes = Vec::new();
    for kept in &found.kept {
        let name = kept.file(&file.with_extension("certificate.json"));
        let name = name.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let text = kept.solution.to_json(file).map_err(AppError::from)?;
        hashes.push((name, RichText::default().code(sha256(text.as_bytes()))));
    }
    let of = found.answer.governing.as_ref().map_or_else(String::new, |case| format!(" of {case}"));
    page.paragraph(
        RichText::new(format!("The fields that prove the bounds{of} are what "))
            .code("soilctl solve --save")
            .text(" and the workbench's button Certificate write, the same bytes each time. ")
            .code("soilctl certify")
            .text(" proves them anew, without the solver. SHA-256 of the bytes:"),
    );
    page.definitions(hashes);
    Ok(())
}
