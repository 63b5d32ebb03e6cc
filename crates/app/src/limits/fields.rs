//! The fields behind bounds, to look at.

use soilctl_certificate::{
    LowerField, Mechanism, ShownSpace, SpaceStress, Statement, UpperField, show_mechanism, show_space,
};
use soilctl_limit_analysis::results::{
    FlowResults, StressResults, Units, write_blocks_vtu, write_members_vtu, write_space_vtu, write_vtu,
};

use crate::AppError;

/// The fields behind bounds, in units that people know. At least one is there.
#[derive(Debug)]
pub struct Fields {
    /// The flow behind the upper bound.
    pub flow: Option<FlowResults>,
    /// The stresses behind the lower bound.
    pub stress: Option<StressResults>,
    /// What lengths and stresses are shown in.
    pub units: Units,
    /// What the problem is, in a few words; may be empty.
    pub title: String,
    /// Blocks in space behind the upper bound of a structure with ends, and where their vertices are: x, y across, z.
    pub blocks: Option<(Mechanism, Vec<[f64; 3]>)>,
    /// The stresses about an end behind the lower bound of such a structure.
    pub end: Option<ShownSpace>,
}

impl Fields {
    /// The fields of a solution, each with its statement; for a factor of safety these differ in strength.
    pub(crate) fn new(
        upper: Option<(&Statement, &UpperField)>,
        lower: Option<(&Statement, &LowerField)>,
        units: Units,
        title: String,
    ) -> Result<Self, AppError> {
        Ok(Self {
            flow: upper.map(|(statement, field)| FlowResults::new(statement, field)).transpose()?,
            stress: lower.map(|(statement, field)| StressResults::new(statement, field)).transpose()?,
            units,
            title,
            blocks: None,
            end: None,
        })
    }

    /// The same with blocks in space.
    pub(crate) fn with_blocks(self, statement: &Statement, mechanism: &Mechanism) -> Result<Self, AppError> {
        let places = show_mechanism(statement, mechanism)?;
        Ok(Self { blocks: Some((mechanism.clone(), places)), ..self })
    }

    /// The same with a stress field about an end.
    pub(crate) fn with_end(self, statement: &Statement, stress: &SpaceStress) -> Result<Self, AppError> {
        Ok(Self { end: Some(show_space(statement, stress)?), ..self })
    }

    /// The problem; that of both bounds has the same geometry.
    ///
    /// # Errors
    /// [`AppError::Request`] if there is no field.
    pub fn statement(&self) -> Result<&Statement, AppError> {
        let flow = self.flow.as_ref().map(FlowResults::statement);
        flow.or(self.stress.as_ref().map(StressResults::statement))
            .ok_or_else(|| AppError::Request("the solution has no field, so there is nothing to show".into()))
    }

    /// Both fields as a document for ParaView (.vtu): velocities, stresses, dissipation, soil.
    ///
    /// # Errors
    /// [`AppError`] if there is no field.
    pub fn vtu(&self) -> Result<String, AppError> {
        Ok(write_vtu(self.flow.as_ref(), self.stress.as_ref(), &self.units)?)
    }

    /// What there is beside both fields as further documents for ParaView, each with a word for its name: what `members` bear by the lower
    /// bound, and in space the `blocks` of the upper bound and their velocities, and the stresses of the lower bound about an `end`.
    ///
    /// # Errors
    /// [`AppError`] if a number cannot be written.
    pub fn further_vtu(&self) -> Result<Vec<(&'static str, String)>, AppError> {
        let mut files = Vec::new();
        let members =
            self.stress.as_ref().map(|stress| write_members_vtu(stress, &self.units)).transpose()?;
        files.extend(members.flatten().map(|text| ("members", text)));
        if let Some((mechanism, places)) = &self.blocks {
            files.push(("blocks", write_blocks_vtu(mechanism, places, &self.units)?));
        }
        if let Some(stress) = &self.end {
            files.push(("end", write_space_vtu(stress, &self.units)?));
        }
        Ok(files)
    }

    /// The mesh of the upper bound for gmsh (.msh).
    ///
    /// # Errors
    /// [`AppError::Request`] if there is no upper bound.
    pub fn msh(&self) -> Result<String, AppError> {
        let none =
            || AppError::Request("--mesh writes the mesh of the upper bound, and there is none".into());
        Ok(self.flow.as_ref().ok_or_else(none)?.msh())
    }
}
