/**
 * From camera frames to kicks.
 *
 * <p>{@link fieldcal.kick.KickFinder} is fed frame by frame, online or from a recording. It keeps one ball track per camera and
 * ball, notices where a track's velocity jumps, joins what several cameras saw of the same kick, follows the ball until it stops,
 * leaves the field, touches a robot or is lost, and hands out a {@link fieldcal.kick.Kick}: every unfiltered detection of that
 * flight, each with its own time and camera.
 *
 * <p>Used by {@code fit} (which decides between flat and chip), {@code calibration} and {@code live}.
 */
@PublicApi
package fieldcal.kick;

import fieldcal.PublicApi;
