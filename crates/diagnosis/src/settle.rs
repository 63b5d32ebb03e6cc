//! Whether the columns of a campaign show the effects that are known.

use soilctl_effects::Channel;

use crate::DiagnosisError;
use crate::data::Data;
use crate::search::{LN_LINKED, LN_RESPONDS, Search};
use crate::setup::FitSetup;
use crate::surface::Surface;

/// The same campaign with what its columns say of the known effects: whether they show them.
///
/// # Errors
/// As [`Search::new`].
pub(crate) fn settled(data: &Data, surface: &Surface) -> Result<Data, DiagnosisError> {
    let mut data = data.clone();
    for which in 0..data.known.len() {
        let effect = data.known[which].active.effect;
        let present = |channel: &Channel| data.channels.contains_key(channel);
        let linked = effect.linked.iter().any(present);
        // As in the search: only what acts on forces may be there without its columns showing it.
        let may_hide = linked && effect.acts_on_force();
        let responds = effect.responses.iter().any(|response| present(&response.channel));
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
                let setup = FitSetup::new(&tried, surface, tried.phi.mean);
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
