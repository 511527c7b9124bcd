package fieldcal.archive;

import java.io.Serializable;
import java.util.List;

/**
 * All matches of a team in a tournament.
 *
 * @param tournament name
 * @param team name
 * @param logs in which it played
 */
record TeamMatches(String tournament, String team, List<LogFile> logs) implements Serializable {}
