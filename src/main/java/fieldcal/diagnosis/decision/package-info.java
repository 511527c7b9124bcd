/**
 * The only place where names are given: it decides which of the effects that a search kept are causes, which are only the form of another, and which cannot be distinguished, within a budget of false alarms over everything that was tried.
 */
package fieldcal.diagnosis.decision;
