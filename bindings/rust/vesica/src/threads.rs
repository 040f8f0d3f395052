// SPDX-License-Identifier: Apache-2.0
//! Calls that are divided among threads.
use alloc::vec::Vec;
use core::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// How many threads work on so many elements, if the caller asks for `threads`.
pub(crate) fn count_for(threads: usize, elements: usize) -> usize {
    // With fewer elements each, starting a thread takes longer than it saves.
    const LEAST: usize = 50_000;
    if threads > 0 {
        return threads;
    }
    thread::available_parallelism().map_or(1, usize::from).min(1 + elements / LEAST)
}

/// The task of each part, by at most so many threads at the same time, this one among them. Results are in the order of
/// parts.
pub(crate) fn each_part<R: Send>(threads: usize, parts: usize, task: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let part = next.fetch_add(1, Ordering::Relaxed);
            if part >= parts {
                return done;
            }
            done.push((part, task(part)));
        }
    };
    let mut results = thread::scope(|scope| {
        // If the system has no more threads, those that there are do the work.
        let start = |_| thread::Builder::new().spawn_scoped(scope, work).ok();
        let others: Vec<_> = (1..threads.min(parts)).map_while(start).collect();
        let mut results = work();
        for other in others {
            results.extend(other.join().expect("a task that panics"));
        }
        results
    });
    results.sort_unstable_by_key(|&(part, _)| part);
    results.into_iter().map(|(_, result)| result).collect()
}
