/**
 * Watches a match frame by frame: a ball model from the medians of its last kicks, the movement limits of both teams, how well the cameras work, and warnings when the ball no longer moves as published.
 *
 * <p>{@link fieldcal.live.LiveMonitor} is the whole of it for a team's AI or a tool: it is given frames and the referee's phase on one thread, does what takes long on an {@link
 * java.util.concurrent.Executor} of its host or in {@link fieldcal.live.LiveMonitor#poll}, and hands out an immutable {@link fieldcal.live.LiveSnapshot} to any thread. It has no threads and no clock of
 * its own: time is that of the frames. Memory is bounded; what comes too fast is dropped and counted.
 */
@PublicApi
package fieldcal.live;

import fieldcal.PublicApi;
