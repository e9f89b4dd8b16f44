//! Named parameters: each is read after those that its expression uses.

use super::problem::EntryProblem;
use super::reader::NumberReader;
use crate::document::{Entry, Written};
use crate::units::{Rule, is_parameter_name, is_reserved_name, referenced_names};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap, HashSet};

impl NumberReader {
    /// Reads the table of parameters.
    pub fn read_parameters(&mut self, entry: &Entry<'_>) {
        let entries = self.reader.any_keys(entry);
        let indices: HashMap<&str, usize> =
            entries.iter().enumerate().map(|(index, entry)| (entry.name, index)).collect();
        let needs: Vec<Vec<usize>> = entries
            .iter()
            .map(|entry| {
                let text = if entry.is_text() { self.reader.written(entry) } else { None };
                let names = if let Some(Written::Text(text)) = text { referenced_names(text) } else { Vec::new() };
                names.iter().filter_map(|name| indices.get(name.as_str()).copied()).collect()
            })
            .collect();
        self.parameters.order = entries.iter().map(|entry| entry.name.to_owned()).collect();
        let (order, stuck) = sorted(&needs);
        self.report_circles(&entries, &needs, &stuck);
        for index in order {
            self.read_parameter(&entries[index]);
        }
    }

    fn read_parameter(&mut self, entry: &Entry<'_>) {
        self.remember(entry);
        let name = entry.name;
        if !is_parameter_name(name) {
            let problem = EntryProblem::BadParameterName { name: name.to_owned(), is_reserved: is_reserved_name(name) };
            self.reader.report(&problem, entry.key_span);
            self.parameters.broken.insert(name.to_owned());
            return;
        }
        let added = self
            .expression(entry)
            .and_then(|expression| self.add(entry, &expression, Rule::Finite).map(|id| (id.0, expression.dimension)));
        match added {
            Some(slot_and_dimension) => {
                self.parameters.known.insert(name.to_owned(), slot_and_dimension);
            }
            None => {
                self.parameters.broken.insert(name.to_owned());
            }
        }
    }

    /// Reports once of each circle among the parameters that could not be sorted.
    fn report_circles(&mut self, entries: &[Entry<'_>], needs: &[Vec<usize>], stuck: &[usize]) {
        let is_stuck: HashSet<usize> = stuck.iter().copied().collect();
        let mut seen = HashSet::new();
        for &start in stuck {
            self.parameters.broken.insert(entries[start].name.to_owned());
            let mut walk = Vec::new();
            let mut at = start;
            // Whoever is stuck needs somebody who is stuck; following that ends in a circle.
            while seen.insert(at) {
                walk.push(at);
                match needs[at].iter().copied().find(|need| is_stuck.contains(need)) {
                    Some(next) => at = next,
                    None => break,
                }
            }
            if let Some(begin) = walk.iter().position(|step| *step == at)
                && needs[walk[walk.len() - 1]].contains(&at)
            {
                let circle = &walk[begin..];
                let names = circle.iter().chain(circle.first()).map(|step| entries[*step].name.to_owned()).collect();
                self.reader.report(&EntryProblem::ParameterCycle { circle: names }, entries[circle[0]].span);
            }
        }
    }
}

/// An order in which each comes after those it needs, first come first served; and those that have none.
fn sorted(needs: &[Vec<usize>]) -> (Vec<usize>, Vec<usize>) {
    let mut waits_for: Vec<usize> = needs.iter().map(Vec::len).collect();
    let mut needed_by: Vec<Vec<usize>> = vec![Vec::new(); needs.len()];
    for (index, list) in needs.iter().enumerate() {
        list.iter().for_each(|need| needed_by[*need].push(index));
    }
    let mut ready: BinaryHeap<Reverse<usize>> =
        (0..needs.len()).filter(|index| waits_for[*index] == 0).map(Reverse).collect();
    let mut order = Vec::with_capacity(needs.len());
    while let Some(Reverse(index)) = ready.pop() {
        order.push(index);
        for &follower in &needed_by[index] {
            waits_for[follower] -= 1;
            if waits_for[follower] == 0 {
                ready.push(Reverse(follower));
            }
        }
    }
    let stuck = (0..needs.len()).filter(|index| waits_for[*index] > 0).collect();
    (order, stuck)
}
