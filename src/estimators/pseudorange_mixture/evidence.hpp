#pragma once

namespace multipath_localization {

/// How much of one count a satellite's range is worth in weighing hypotheses. Reflections last: all that a
/// satellite says within `evidence_time` [s] counts once. One that comes into view, or comes back after
/// having been `unseen` [s], says at once what it would have said by then; the others add `information` [s].
double evidence_share(double information, double unseen, double evidence_time);

/// Log of how much less probable a new hypothesis is that lies `distance` [m] from where the others have the
/// robot, who know that to `sigma` [m]: they are wrong by about as much as reflections delay, which is
/// `delay` [m] in the mean. Few satellites may fit together anywhere.
double log_probability_of_place(double distance, double sigma, double delay);

}  // namespace multipath_localization
