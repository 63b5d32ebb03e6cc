//! Effects that are known before the strokes are looked at: part of the baseline, with their amplitudes held.

use soilctl_effects::{Active, Channel, Effect, Loaded, Reference};

use crate::DiagnosisError;
use crate::data::Data;
use crate::search::{LN_LINKED, LN_RESPONDS, Search};
use crate::setup::Setup;
use crate::surface::Surface;

/// An effect of a model file.
#[derive(Clone, Copy)]
pub(crate) struct Known {
    pub(crate) active: Active<'static>,
    /// Whether columns that its amplitude fixes show it.
    pub(crate) linked: bool,
    /// Whether columns respond with a strength of their own.
    pub(crate) responds: bool,
}

impl std::fmt::Debug for Known {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Active { effect, amplitude, shape } = self.active;
        write!(f, "{} {amplitude} {shape} {} {}", effect.id(), self.linked, self.responds)
    }
}

impl Data {
    /// Takes the effects and the gravity of a model file as known. Amplitudes are held in every fit, and the effects are not
    /// looked for again; the soil is fitted anew. Parameters, also those of what is found, refer to what the file's refer to.
    pub fn know(&mut self, file: &Loaded) {
        self.known = file.effects().map(|active| Known { active, linked: true, responds: true }).collect();
        self.gravity_m_s2 = file.file().soil.gravity_m_s2;
        if self.known.is_empty() {
            return;
        }
        let (own, theirs) = (self.reference.clone(), &file.file().reference);
        let ordered = self.known.iter().any(|known| known.active.effect.id() == "preparation_drift");
        self.refer_to(Reference {
            depth_m: theirs.depth_m,
            alpha_deg: theirs.alpha_deg,
            delta_set_deg: own.delta_set_deg,
            speed_mps: theirs.speed_mps.or(own.speed_mps),
            time_s: theirs.time_s.or(own.time_s),
            base_deg: theirs.base_deg.or(own.base_deg),
            // Other preparations have other names; only a drift over those of the file needs them.
            batches: if ordered { theirs.batches.clone() } else { own.batches },
        });
    }

    /// Known effects that change what a column reads by an amount that is known too.
    pub(crate) fn known_linked(&self, channel: Channel) -> impl Iterator<Item = &Active<'static>> {
        let shows = move |known: &&Known| known.linked && known.active.effect.linked().contains(&channel);
        self.known.iter().filter(shows).map(|known| &known.active)
    }

    /// Known effects to which columns respond.
    pub(crate) fn known_responses(&self) -> impl Iterator<Item = &Active<'static>> {
        self.known.iter().filter(|known| known.responds).map(|known| &known.active)
    }

    pub(crate) fn is_known(&self, effect: &dyn Effect) -> bool {
        self.known.iter().any(|known| known.active.effect.id() == effect.id())
    }
}

/// The same campaign with what its columns say of the known effects: whether they show them.
///
/// # Errors
/// As [`Search::new`].
pub(crate) fn settled(data: &Data, surface: &Surface) -> Result<Data, DiagnosisError> {
    let mut data = data.clone();
    for which in 0..data.known.len() {
        let effect = data.known[which].active.effect;
        let present = |channel: &Channel| data.channels.contains_key(channel);
        let linked = effect.linked().iter().any(present);
        // As in the search: only what acts on forces may be there without its columns showing it.
        let may_hide = linked && effect.acts_on_force();
        let responds = effect.responses().iter().any(|response| present(&response.channel));
        if !linked && !responds {
            continue;
        }
        let mut best: Option<(f64, Data)> = None;
        for (linked, of_linked) in [(true, LN_LINKED[0]), (false, LN_LINKED[1])] {
            for (responding, of_responses) in [(true, LN_RESPONDS[0]), (false, LN_RESPONDS[1])] {
                if (!linked && !may_hide) || (responding && (!responds || (!linked && may_hide))) {
                    continue;
                }
                let mut tried = data.clone();
                tried.known[which].linked = linked;
                tried.known[which].responds = responding;
                let setup = Setup::new(&tried, surface, tried.phi.mean);
                let evidence = Search::new(&setup)?.log_evidence() + of_linked + of_responses;
                if best.as_ref().is_none_or(|(most, _)| evidence > *most) {
                    best = Some((evidence, tried));
                }
            }
        }
        if let Some((_, tried)) = best {
            data = tried;
        }
    }
    Ok(data)
}
