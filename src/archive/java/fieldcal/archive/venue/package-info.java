/**
 * What many matches say together: {@link fieldcal.archive.venue.VenueFinder} groups matches by venue, {@link fieldcal.archive.venue.ChangeFinder} cuts series of measurements where they change, and {@link
 * fieldcal.archive.venue.VenueStudy} makes carpets and dated changes of both. Knows neither Spark nor files.
 */
package fieldcal.archive.venue;
