/**
 * Which effects, named or learned, together explain what the simple model leaves: everything in a dictionary is score-tested, the best effects are added, all are refitted jointly and weak ones are removed, until nothing gains more than its penalty. The search gives no names:
 * what it keeps is judged by {@code fieldcal.diagnosis.decision}. It knows effects by their interface alone.
 */
package fieldcal.diagnosis.search;
