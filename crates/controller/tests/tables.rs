//! The tables of the sequences: nothing unreachable, no dead end, every way out leads back to the caller.
#![allow(clippy::unwrap_used)]

use soilctl_controller::SequenceId;
use soilctl_controller::sequence::{Action, Condition, Goto, MOST_NESTED, table};

#[test]
fn every_step_is_reached_and_leads_to_an_end() {
    for id in SequenceId::ALL {
        let steps = table(id).steps;
        let mut reached = vec![false; steps.len()];
        let mut open = vec![0_usize];
        while let Some(at) = open.pop() {
            if std::mem::replace(&mut reached[at], true) {
                continue;
            }
            for next in steps[at].next {
                if let Goto::Step(to) = next.go {
                    assert!(usize::from(to) < steps.len(), "{id:?} {}", steps[at].name);
                    open.push(usize::from(to));
                }
            }
        }
        assert!(reached.iter().all(|&reached| reached), "{id:?} {reached:?}");

        // Backwards from the ends.
        let mut ends = vec![false; steps.len()];
        for _ in 0..steps.len() {
            for (i, step) in steps.iter().enumerate() {
                ends[i] |= step.next.iter().any(|next| match next.go {
                    Goto::Step(to) => ends[usize::from(to)],
                    Goto::Succeed | Goto::Fail => true,
                });
            }
        }
        assert!(ends.iter().all(|&end| end), "{id:?} {ends:?}");
    }
}

/// A step is left whatever its action comes to.
#[test]
fn no_outcome_is_left_out() {
    for id in SequenceId::ALL {
        for step in table(id).steps {
            let has = |condition| step.next.iter().any(|next| next.when == condition);
            let complete = match step.action {
                Action::Call(_) => has(Condition::CallSucceeded) && has(Condition::CallFailed),
                _ => has(Condition::Done) || has(Condition::Always) || has(Condition::Continued),
            };
            assert!(complete, "{id:?} {}", step.name);
            // What always holds comes last.
            let last = step.next.last().unwrap().when;
            let early = &step.next[..step.next.len() - 1];
            assert!(
                early.iter().all(|next| next.when != Condition::Always && next.when != Condition::Done),
                "{last:?}"
            );
        }
    }
}

#[test]
fn calls_are_not_nested_too_deep() {
    fn depth(id: SequenceId, left: usize) -> usize {
        assert!(left > 0, "{id:?} calls itself");
        let called = table(id).steps.iter().filter_map(|step| match step.action {
            Action::Call(called) => Some(depth(called, left - 1)),
            _ => None,
        });
        1 + called.max().unwrap_or(0)
    }
    for id in SequenceId::ALL {
        assert!(depth(id, MOST_NESTED) <= MOST_NESTED);
    }
}
