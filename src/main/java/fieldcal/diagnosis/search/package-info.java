/**
 * Which effects, named or learned, together explain what the simple model leaves: score tests of everything in a dictionary, the best added, all refitted jointly, weak ones removed, until nothing takes a share worth having. Gives no names:
 * what a search keeps is judged by {@code fieldcal.diagnosis.decision}. Knows effects by their interface alone.
 */
package fieldcal.diagnosis.search;
