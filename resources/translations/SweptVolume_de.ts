<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>SweptVolumePreferences</name>
  <message>
   <source>General</source>
   <translation>Allgemein</translation>
  </message>
  <message>
   <source>New envelopes</source>
   <translation>Neue Hüllen</translation>
  </message>
  <message>
   <source>Resolution</source>
   <translation>Auflösung</translation>
  </message>
  <message>
   <source>Cells along the longest side of the swept volume, for new envelopes</source>
   <translation>Zellen entlang der längsten Seite des überstrichenen Volumens, für neue Hüllen</translation>
  </message>
  <message>
   <source>Tolerance</source>
   <translation>Toleranz</translation>
  </message>
  <message>
   <source>How far simplification may move the surface of a new envelope; 0: no simplification</source>
   <translation>Wie weit Vereinfachung die Oberfläche einer neuen Hülle verschieben darf; 0: keine Vereinfachung</translation>
  </message>
  <message>
   <source>Backend</source>
   <translation>Rechenwerk</translation>
  </message>
  <message>
   <source>Processor that samples new envelopes</source>
   <translation>Prozessor, der neue Hüllen abtastet</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>CPU</source>
   <translation>CPU</translation>
  </message>
  <message>
   <source>GPU</source>
   <translation>GPU</translation>
  </message>
  <message>
   <source>Runs</source>
   <translation>Läufe</translation>
  </message>
  <message>
   <source>Threads</source>
   <translation>Threads</translation>
  </message>
  <message>
   <source>Leave one core free to keep FreeCAD responsive while a large envelope is computed</source>
   <translation>Ein Kern weniger als vorhanden hält FreeCAD bedienbar, während eine große Hülle berechnet wird</translation>
  </message>
  <message>
   <source>all cores</source>
   <translation>alle Kerne</translation>
  </message>
  <message>
   <source>Memory limit</source>
   <translation>Speichergrenze</translation>
  </message>
  <message>
   <source>A computation that would need more memory is refused before it starts</source>
   <translation>Eine Berechnung, die mehr Speicher bräuchte, wird vor dem Start abgelehnt</translation>
  </message>
  <message>
   <source> MiB</source>
   <translation> MiB</translation>
  </message>
  <message>
   <source>three quarters of the free memory</source>
   <translation>drei Viertel des freien Speichers</translation>
  </message>
  <message>
   <source>Reports</source>
   <translation>Berichte</translation>
  </message>
  <message>
   <source>Template</source>
   <translation>Vorlage</translation>
  </message>
  <message>
   <source>HTML file with placeholders, for reports and studies; empty: the built-in template</source>
   <translation>HTML-Datei mit Platzhaltern für Berichte und Studien; leer: die eingebaute Vorlage</translation>
  </message>
  <message>
   <source>PDF template</source>
   <translation>PDF-Vorlage</translation>
  </message>
  <message>
   <source>The template for PDF, in the HTML subset of Qt's rich text; empty: the built-in template</source>
   <translation>Die Vorlage für PDF, im HTML-Umfang von Qts Rich Text; leer: die eingebaute Vorlage</translation>
  </message>
  <message>
   <source>Motion editor</source>
   <translation>Bewegungseditor</translation>
  </message>
  <message>
   <source>Preview resolution</source>
   <translation>Auflösung der Vorschau</translation>
  </message>
  <message>
   <source>Cells along the longest side of the coarse envelope in the motion editor</source>
   <translation>Zellen entlang der längsten Seite der groben Hülle im Bewegungseditor</translation>
  </message>
  <message>
   <source>Show a coarse envelope while a motion is edited</source>
   <translation>Beim Bearbeiten einer Bewegung eine grobe Hülle zeigen</translation>
  </message>
 </context>
 <context>
  <name>SweptVolume_Commands</name>
  <message>
   <source>Check clearance</source>
   <translation>Abstand prüfen</translation>
  </message>
  <message>
   <source>Measures the smallest distance from the moving parts to every neighbour over the whole motion. Select an envelope, or parts and a motion, or an existing check</source>
   <translation>Misst den kleinsten Abstand der bewegten Teile zu jedem Nachbarn über die ganze Bewegung. Eine Hülle, Teile und eine Bewegung oder eine vorhandene Prüfung auswählen</translation>
  </message>
  <message>
   <source>Check mechanism</source>
   <translation>Mechanismus prüfen</translation>
  </message>
  <message>
   <source>Measures the smallest distance between parts that move at the same time, for every pair and over the whole motion. Select their motions, or an existing check; without a selection all motions that know their parts are used</source>
   <translation>Misst den kleinsten Abstand zwischen Teilen, die sich gleichzeitig bewegen, für jedes Paar und über die ganze Bewegung. Ihre Bewegungen oder eine vorhandene Prüfung auswählen; ohne Auswahl werden alle Bewegungen verwendet, die ihre Teile kennen</translation>
  </message>
  <message>
   <source>Check reserved spaces</source>
   <translation>Reservierte Räume prüfen</translation>
  </message>
  <message>
   <source>Measures distances between envelopes, their solids or parts as they stand, and the volume that two of them share. Select two or more objects, or a shared volume to recompute it</source>
   <translation>Misst Abstände zwischen Hüllen, ihren Festkörpern oder Teilen, so wie sie stehen, und das Volumen, das zwei davon gemeinsam haben. Zwei oder mehr Objekte auswählen, oder ein gemeinsames Volumen, um es neu zu berechnen</translation>
  </message>
  <message>
   <source>Create envelope...</source>
   <translation>Hülle erzeugen …</translation>
  </message>
  <message>
   <source>Computes the space that the selected parts occupy during a motion. Select solids or meshes, also inside groups and links, and a motion</source>
   <translation>Berechnet den Raum, den die ausgewählten Teile während einer Bewegung einnehmen. Festkörper oder Netze auswählen, auch in Gruppen und Verknüpfungen, und eine Bewegung</translation>
  </message>
  <message>
   <source>Open the demo</source>
   <translation>Beispiel öffnen</translation>
  </message>
  <message>
   <source>Opens an example: a starter motor is installed past its neighbours</source>
   <translation>Öffnet ein Beispiel: Ein Anlasser wird an seinen Nachbarn vorbei eingebaut</translation>
  </message>
  <message>
   <source>Edit envelope...</source>
   <translation>Hülle bearbeiten …</translation>
  </message>
  <message>
   <source>Changes parts, motion or accuracy of the selected envelope</source>
   <translation>Ändert Teile, Bewegung oder Genauigkeit der ausgewählten Hülle</translation>
  </message>
  <message>
   <source>Edit motion...</source>
   <translation>Bewegung bearbeiten …</translation>
  </message>
  <message>
   <source>Edits the keys of the selected motion in a table and in the 3D view, and plays the motion</source>
   <translation>Bearbeitet die Stützstellen der ausgewählten Bewegung in einer Tabelle und in der 3D-Ansicht und spielt die Bewegung ab</translation>
  </message>
  <message>
   <source>Settings of the source...</source>
   <translation>Einstellungen der Quelle...</translation>
  </message>
  <message>
   <source>Changes how the source of the selected motion is read (accuracy, orientation, duration, start and end, unit), and reads it again</source>
   <translation>Ändert, wie die Quelle der ausgewählten Bewegung gelesen wird (Genauigkeit, Ausrichtung, Dauer, Start und Ende, Einheit), und liest sie neu</translation>
  </message>
  <message>
   <source>Export envelope...</source>
   <translation>Hülle exportieren …</translation>
  </message>
  <message>
   <source>Writes the selected envelope as STEP, BREP, STL, PLY, OBJ, OFF or 3MF and checks the file. For a selected solid, its tolerance and limits apply</source>
   <translation>Schreibt die ausgewählte Hülle als STEP, BREP, STL, PLY, OBJ, OFF oder 3MF und prüft die Datei. Bei einem ausgewählten Festkörper gelten dessen Toleranz und Grenzen</translation>
  </message>
  <message>
   <source>Export report...</source>
   <translation>Bericht exportieren ...</translation>
  </message>
  <message>
   <source>Writes the results of the selected check or study as one HTML file, for checks with a 3D view, or as PDF</source>
   <translation>Schreibt die Ergebnisse der ausgewählten Prüfung oder Studie als eine HTML-Datei, bei Prüfungen mit 3D-Ansicht, oder als PDF</translation>
  </message>
  <message>
   <source>Find path...</source>
   <translation>Bahn finden...</translation>
  </message>
  <message>
   <source>Finds a path on which the selected part reaches its place without coming too close to its neighbours. Select the part first, then its neighbours; a selected motion gives start and goal</source>
   <translation>Findet eine Bahn, auf der das ausgewählte Teil seinen Platz erreicht, ohne seinen Nachbarn zu nahe zu kommen. Zuerst das Teil auswählen, dann seine Nachbarn; eine ausgewählte Bewegung gibt Start und Ziel</translation>
  </message>
  <message>
   <source>Improve path...</source>
   <translation>Bahn verbessern...</translation>
  </message>
  <message>
   <source>Removes clashes from the selected motion, makes it shorter with fewer keys, or increases its clearance. The result is a new motion; the selected one is kept</source>
   <translation>Beseitigt Kollisionen der ausgewählten Bewegung, macht sie kürzer mit weniger Stützstellen oder vergrößert ihren Abstand. Das Ergebnis ist eine neue Bewegung; die ausgewählte bleibt</translation>
  </message>
  <message>
   <source>What made this?</source>
   <translation>Was hat das erzeugt?</translation>
  </message>
  <message>
   <source>Colours the selected envelope by the faces that made it. A click on the envelope shows which face or edge of which part passed there, and when</source>
   <translation>Färbt die ausgewählte Hülle nach den Flächen, die sie erzeugt haben. Ein Klick auf die Hülle zeigt, welche Fläche oder Kante welches Teils dort vorbeikam, und wann</translation>
  </message>
  <message>
   <source>Make solid</source>
   <translation>Festkörper erzeugen</translation>
  </message>
  <message>
   <source>Converts the selected envelope to a solid for Boolean operations, measuring and STEP. A selected solid is converted again</source>
   <translation>Wandelt die ausgewählte Hülle in einen Festkörper für boolesche Operationen, Messen und STEP um. Ein ausgewählter Festkörper wird neu erzeugt</translation>
  </message>
  <message>
   <source>Motion from driven value...</source>
   <translation>Bewegung aus gesteuertem Wert...</translation>
  </message>
  <message>
   <source>Records the motion of a part while a value changes: a spreadsheet cell, a sketch dimension or a variable of an assembly. Select the object with the value, then the part; without a part, every part that moves gets a motion</source>
   <translation>Zeichnet die Bewegung eines Teils auf, während sich ein Wert ändert: eine Tabellenzelle, ein Skizzenmaß oder eine Variable einer Baugruppe. Das Objekt mit dem Wert auswählen, dann das Teil; ohne Teil erhält jedes bewegte Teil eine Bewegung</translation>
  </message>
  <message>
   <source>Motion from file...</source>
   <translation>Bewegung aus Datei …</translation>
  </message>
  <message>
   <source>Reads a motion from a CSV file. Each row is time, position and quaternion (t,tx,ty,tz,qx,qy,qz,qw), or the 16 numbers of a matrix</source>
   <translation>Liest eine Bewegung aus einer CSV-Datei. Jede Zeile ist Zeit, Ort und Quaternion (t,tx,ty,tz,qx,qy,qz,qw) oder die 16 Zahlen einer Matrix</translation>
  </message>
  <message>
   <source>Motion from selected placements</source>
   <translation>Bewegung aus ausgewählten Platzierungen</translation>
  </message>
  <message>
   <source>Makes a motion from the placements of the selected objects, in the order of selection. The motion stays linked: if you move an object, its pose follows</source>
   <translation>Erzeugt eine Bewegung aus den Platzierungen der ausgewählten Objekte, in der Reihenfolge der Auswahl. Die Bewegung bleibt verknüpft: Wird ein Objekt verschoben, folgt seine Lage</translation>
  </message>
  <message>
   <source>Motion from object...</source>
   <translation>Bewegung aus Objekt …</translation>
  </message>
  <message>
   <source>Makes a motion from the selected wire, sketch, robot trajectory, link array, Draft array, CAM operation or assembly simulation. A second curve sets the orientation. The motion stays linked to its source</source>
   <translation>Erzeugt eine Bewegung aus dem ausgewählten Linienzug, der Skizze, Roboterbahn, Link-Anordnung, Draft-Anordnung, CAM-Operation oder Baugruppen-Simulation. Eine zweite Kurve bestimmt die Ausrichtung. Die Bewegung bleibt mit ihrer Quelle verknüpft</translation>
  </message>
  <message>
   <source>New motion...</source>
   <translation>Neue Bewegung …</translation>
  </message>
  <message>
   <source>Opens the motion editor: move the selected part step by step and capture its placements</source>
   <translation>Öffnet den Bewegungseditor: Das ausgewählte Teil Schritt für Schritt bewegen und seine Platzierungen übernehmen</translation>
  </message>
  <message>
   <source>Recompute envelope</source>
   <translation>Hülle neu berechnen</translation>
  </message>
  <message>
   <source>Recomputes the selected envelope from its current parts and motion; without a selection, the first stale envelope</source>
   <translation>Berechnet die ausgewählte Hülle aus ihren jetzigen Teilen und ihrer Bewegung neu; ohne Auswahl die erste veraltete Hülle</translation>
  </message>
  <message>
   <source>Reload motion</source>
   <translation>Bewegung neu laden</translation>
  </message>
  <message>
   <source>Reads the file or source of the selected motion again; motions of the same driven value or simulation are read together</source>
   <translation>Liest die Datei oder Quelle der ausgewählten Bewegung neu; Bewegungen desselben gesteuerten Werts oder derselben Simulation werden gemeinsam gelesen</translation>
  </message>
  <message>
   <source>Sequence...</source>
   <translation>Einbaufolge...</translation>
  </message>
  <message>
   <source>Finds installation paths for the selected parts, one after the other: each part keeps clear of those already in place. The order is given or found. Opens a selected sequence</source>
   <translation>Findet Einbaubahnen für die ausgewählten Teile, eines nach dem anderen: Jedes Teil bleibt frei von denen, die schon da sind. Die Reihenfolge ist gegeben oder wird gefunden. Öffnet eine ausgewählte Einbaufolge</translation>
  </message>
  <message>
   <source>Study...</source>
   <translation>Studie...</translation>
  </message>
  <message>
   <source>Runs many computations, several at once: those of a study file, or the envelopes and clearance checks of the document. Select some of them, or an existing study</source>
   <translation>Führt viele Berechnungen aus, mehrere gleichzeitig: die einer Studiendatei oder die Hüllen und Abstandsprüfungen des Dokuments. Einige davon auswählen oder eine vorhandene Studie</translation>
  </message>
  <message>
   <source>Keyboard to the tree or panel</source>
   <translation>Tastatur zum Baum oder Panel</translation>
  </message>
  <message>
   <source>Moves the keyboard focus to the tree: arrow keys select, Ctrl with arrow keys and Space selects more. From the tree, moves it to the open panel</source>
   <translation>Setzt den Tastaturfokus in den Baum: Pfeiltasten wählen, Strg mit Pfeiltasten und Leertaste wählt weitere. Vom Baum geht er zum offenen Panel</translation>
  </message>
  <message>
   <source>Improve path</source>
   <translation>Bahn verbessern</translation>
  </message>
  <message>
   <source>Find path</source>
   <translation>Bahn finden</translation>
  </message>
  <message>
   <source>Sequence</source>
   <translation>Einbaufolge</translation>
  </message>
  <message>
   <source>Edit envelope</source>
   <translation>Hülle bearbeiten</translation>
  </message>
  <message>
   <source>Export envelope</source>
   <translation>Hülle exportieren</translation>
  </message>
  <message>
   <source>Edit motion</source>
   <translation>Bewegung bearbeiten</translation>
  </message>
  <message>
   <source>Settings of the source</source>
   <translation>Einstellungen der Quelle</translation>
  </message>
  <message>
   <source>Create envelope</source>
   <translation>Hülle erzeugen</translation>
  </message>
  <message>
   <source>Compute again</source>
   <translation>Neu berechnen</translation>
  </message>
  <message>
   <source>Make solid again</source>
   <translation>Festkörper neu erzeugen</translation>
  </message>
  <message>
   <source>Export</source>
   <translation>Exportieren</translation>
  </message>
 </context>
 <context>
  <name>SweptVolume_Core</name>
  <message>
   <source>The part has no surface: choose a solid or a mesh with triangles.</source>
   <translation>Das Teil hat keine Oberfläche: Wählen Sie einen Festkörper oder ein Netz mit Dreiecken.</translation>
  </message>
  <message>
   <source>The mesh has vertices whose coordinates are not numbers: repair the mesh or export it again.</source>
   <translation>Das Netz hat Punkte, deren Koordinaten keine Zahlen sind: Reparieren Sie das Netz, oder exportieren Sie es neu.</translation>
  </message>
  <message>
   <source>The part encloses no volume: choose a solid or a closed mesh.</source>
   <translation>Das Teil umschließt keinen Raum: Wählen Sie einen Festkörper oder ein geschlossenes Netz.</translation>
  </message>
  <message>
   <source>The part has holes that its motion does not close, so inside and outside cannot be told apart: close the holes.</source>
   <translation>Das Teil hat Löcher, die seine Bewegung nicht schließt; innen und außen sind nicht zu unterscheiden: Schließen Sie die Löcher.</translation>
  </message>
  <message>
   <source>The part is too far from the origin for its size to be computed exactly: move it closer to the origin.</source>
   <translation>Das Teil liegt für seine Größe zu weit vom Ursprung, um genau gerechnet zu werden: Rücken Sie es näher an den Ursprung.</translation>
  </message>
  <message>
   <source>The part or the motion is too large: check the unit of length.</source>
   <translation>Das Teil oder die Bewegung ist zu groß: Prüfen Sie die Längeneinheit.</translation>
  </message>
  <message>
   <source>The cell is larger than the part: choose a smaller cell or a higher resolution.</source>
   <translation>Die Zelle ist größer als das Teil: Wählen Sie eine kleinere Zelle oder eine höhere Auflösung.</translation>
  </message>
  <message>
   <source>A setting is outside its allowed range: the text in brackets names it and the range.</source>
   <translation>Eine Einstellung liegt außerhalb des erlaubten Bereichs: Der Text in Klammern nennt sie und den Bereich.</translation>
  </message>
  <message>
   <source>The motion has no poses: give at least one.</source>
   <translation>Die Bewegung hat keine Lagen: Geben Sie mindestens eine an.</translation>
  </message>
  <message>
   <source>A pose scales, shears or mirrors the part: a pose may only rotate and translate.</source>
   <translation>Eine Lage skaliert, schert oder spiegelt das Teil: Eine Lage darf nur drehen und verschieben.</translation>
  </message>
  <message>
   <source>A pose cannot be used: its numbers must be finite, and times must not decrease.</source>
   <translation>Eine Lage ist nicht verwendbar: Ihre Zahlen müssen endlich sein, und Zeiten dürfen nicht abnehmen.</translation>
  </message>
  <message>
   <source>The part turns by 180 degrees between two poses, so the direction is ambiguous: add a pose between them.</source>
   <translation>Das Teil dreht sich zwischen zwei Lagen um 180 Grad, die Richtung ist mehrdeutig: Fügen Sie eine Lage dazwischen ein.</translation>
  </message>
  <message>
   <source>Two parts overlap in their installed positions: move one of them, or set the rule of the pair to Ignore.</source>
   <translation>Zwei Teile überschneiden sich in ihrer Einbaulage: Verschieben Sie eines, oder setzen Sie die Regel des Paars auf „Übergangen“.</translation>
  </message>
  <message>
   <source>Two parts are nearer than the required distance in their installed positions: reduce the required distance, or allow contact for the pair.</source>
   <translation>Zwei Teile sind in ihrer Einbaulage näher als der Sollabstand: Verringern Sie den Sollabstand, oder erlauben Sie dem Paar Kontakt.</translation>
  </message>
  <message>
   <source>The file cannot be read: the text in brackets says where it is damaged.</source>
   <translation>Die Datei kann nicht gelesen werden: Der Text in Klammern sagt, wo sie beschädigt ist.</translation>
  </message>
  <message>
   <source>The file extension is not supported: use one of those in brackets.</source>
   <translation>Die Dateiendung wird nicht unterstützt: Verwenden Sie eine der in Klammern genannten.</translation>
  </message>
  <message>
   <source>The file is larger than the limit for reading: split it or reduce it.</source>
   <translation>Die Datei ist größer als die Lesegrenze: Teilen oder verkleinern Sie sie.</translation>
  </message>
  <message>
   <source>The computation needs more memory than allowed: choose a larger cell, or raise the memory limit in the preferences.</source>
   <translation>Die Berechnung braucht mehr Speicher als erlaubt: Wählen Sie eine größere Zelle, oder erhöhen Sie die Speichergrenze in den Einstellungen.</translation>
  </message>
  <message>
   <source>The result would have too many triangles: choose a larger cell or a lower resolution.</source>
   <translation>Das Ergebnis hätte zu viele Dreiecke: Wählen Sie eine größere Zelle oder eine geringere Auflösung.</translation>
  </message>
  <message>
   <source>The solid would have too many faces: set a larger tolerance, or export a mesh file.</source>
   <translation>Der Festkörper hätte zu viele Flächen: Geben Sie eine größere Toleranz an, oder exportieren Sie eine Netzdatei.</translation>
  </message>
  <message>
   <source>There was not enough memory: choose a larger cell or a lower resolution.</source>
   <translation>Der Speicher reichte nicht aus: Wählen Sie eine größere Zelle oder eine geringere Auflösung.</translation>
  </message>
  <message>
   <source>Cancelled.</source>
   <translation>Abgebrochen.</translation>
  </message>
  <message>
   <source>There is no neighbour to check: choose at least one part that stands still.</source>
   <translation>Es gibt keinen Nachbarn zu prüfen: Wählen Sie mindestens ein stillstehendes Teil.</translation>
  </message>
  <message>
   <source>A rule cannot be applied: correct it or remove it.</source>
   <translation>Eine Regel ist nicht anwendbar: Berichtigen oder entfernen Sie sie.</translation>
  </message>
  <message>
   <source>The report template has an unknown placeholder: correct the template.</source>
   <translation>Die Berichtsvorlage enthält einen unbekannten Platzhalter: Berichtigen Sie die Vorlage.</translation>
  </message>
  <message>
   <source>A neighbour is in the way at the goal: move it, reduce the required distance, or allow contact.</source>
   <translation>Am Ziel ist ein Nachbar im Weg: Verschieben Sie ihn, verringern Sie den Sollabstand, oder erlauben Sie Kontakt.</translation>
  </message>
  <message>
   <source>A neighbour is in the way at the start: move it, reduce the required distance, or allow contact.</source>
   <translation>Am Start ist ein Nachbar im Weg: Verschieben Sie ihn, verringern Sie den Sollabstand, oder erlauben Sie Kontakt.</translation>
  </message>
  <message>
   <source>A neighbour is in the way at a locked key: move it, reduce the required distance, or unlock the key.</source>
   <translation>An einer gesperrten Stützstelle ist ein Nachbar im Weg: Verschieben Sie ihn, verringern Sie den Sollabstand, oder entsperren Sie die Stützstelle.</translation>
  </message>
  <message>
   <source>Start and goal are the same: choose another start.</source>
   <translation>Start und Ziel sind gleich: Wählen Sie einen anderen Start.</translation>
  </message>
  <message>
   <source>No start is given: give a placement, a distance or a direction.</source>
   <translation>Kein Start ist angegeben: Geben Sie eine Platzierung, einen Abstand oder eine Richtung an.</translation>
  </message>
  <message>
   <source>The file could not be written: check the folder, its permissions and the free disk space.</source>
   <translation>Die Datei konnte nicht geschrieben werden: Prüfen Sie Ordner, Rechte und freien Platz.</translation>
  </message>
  <message>
   <source>OpenCASCADE could not build the solid: set a tolerance, or export a mesh file.</source>
   <translation>OpenCASCADE konnte den Festkörper nicht bauen: Geben Sie eine Toleranz an, oder exportieren Sie eine Netzdatei.</translation>
  </message>
  <message>
   <source>No usable graphics device was found: set Backend to CPU.</source>
   <translation>Keine brauchbare Grafikkarte gefunden: Stellen Sie das Rechenwerk auf CPU.</translation>
  </message>
  <message>
   <source>The graphics device failed during the computation: set Backend to CPU.</source>
   <translation>Die Grafikkarte versagte während der Berechnung: Stellen Sie das Rechenwerk auf CPU.</translation>
  </message>
  <message>
   <source>Solids of one part overlap: select each solid on its own, or fuse them first.</source>
   <translation>Festkörper eines Teils überschneiden sich: Wählen Sie jeden einzeln, oder vereinigen Sie sie vorher.</translation>
  </message>
  <message>
   <source>The volume that two parts share cannot be computed: repair the meshes, or move one part slightly.</source>
   <translation>Das gemeinsame Volumen zweier Teile ist nicht berechenbar: Reparieren Sie die Netze, oder verschieben Sie ein Teil geringfügig.</translation>
  </message>
  <message>
   <source>The part has holes, but its motion closes them; the result is valid.</source>
   <translation>Das Teil hat Löcher, aber seine Bewegung schließt sie; das Ergebnis ist gültig.</translation>
  </message>
  <message>
   <source>Triangles with zero area were removed.</source>
   <translation>Dreiecke ohne Fläche wurden entfernt.</translation>
  </message>
  <message>
   <source>Duplicate triangles were removed.</source>
   <translation>Doppelte Dreiecke wurden entfernt.</translation>
  </message>
  <message>
   <source>Pairs of coincident triangles with opposite orientation were removed.</source>
   <translation>Paare deckungsgleicher, entgegengesetzt ausgerichteter Dreiecke wurden entfernt.</translation>
  </message>
  <message>
   <source>The depth of an allowed contact was measured, but is not proven to be the largest.</source>
   <translation>Die Tiefe eines erlaubten Kontakts wurde gemessen, ist aber nicht als größte bewiesen.</translation>
  </message>
  <message>
   <source>Some poses have the same time as the pose before; their order was kept.</source>
   <translation>Manche Lagen haben dieselbe Zeit wie die vorige; ihre Reihenfolge wurde beibehalten.</translation>
  </message>
  <message>
   <source>The triangles of the part faced inwards; all were reversed.</source>
   <translation>Die Dreiecke des Teils zeigten nach innen; alle wurden umgekehrt.</translation>
  </message>
  <message>
   <source>Neighbouring triangles of the part have opposite orientations: check the mesh.</source>
   <translation>Benachbarte Dreiecke des Teils sind entgegengesetzt ausgerichtet: Prüfen Sie das Netz.</translation>
  </message>
  <message>
   <source>The surface of the part cannot be oriented (as a Möbius strip): check the mesh.</source>
   <translation>Die Oberfläche des Teils ist nicht orientierbar (wie ein Möbiusband): Prüfen Sie das Netz.</translation>
  </message>
  <message>
   <source>Some edges of the part have more than two triangles: check the mesh.</source>
   <translation>Manche Kanten des Teils haben mehr als zwei Dreiecke: Prüfen Sie das Netz.</translation>
  </message>
  <message>
   <source>The part intersects itself, and some of its regions face inwards: repair the mesh.</source>
   <translation>Das Teil durchdringt sich selbst, und Bereiche zeigen nach innen: Reparieren Sie das Netz.</translation>
  </message>
  <message>
   <source>The part has cavities; they do not change the envelope unless Keep cavities is set.</source>
   <translation>Das Teil hat Hohlräume; sie ändern die Hülle nur, wenn „Hohlräume behalten“ gesetzt ist.</translation>
  </message>
  <message>
   <source>Some bodies of the part lie inside others; they count as material.</source>
   <translation>Manche Körper des Teils liegen in anderen; sie zählen als Material.</translation>
  </message>
  <message>
   <source>Poses equal to the one before were removed.</source>
   <translation>Lagen, die der vorigen gleichen, wurden entfernt.</translation>
  </message>
  <message>
   <source>Poses with small rounding errors were corrected to rigid movements.</source>
   <translation>Lagen mit kleinen Rundungsfehlern wurden zu starren Bewegungen berichtigt.</translation>
  </message>
  <message>
   <source>Cavities inside the envelope were filled; set Keep cavities to keep them.</source>
   <translation>Hohlräume in der Hülle wurden gefüllt; „Hohlräume behalten“ erhält sie.</translation>
  </message>
  <message>
   <source>Some triangles of the envelope intersect: change the cell size slightly if you need a solid.</source>
   <translation>Manche Dreiecke der Hülle durchdringen sich: Ändern Sie die Zellgröße etwas, wenn Sie einen Festkörper brauchen.</translation>
  </message>
  <message>
   <source>The envelope was not simplified: the text in brackets says why.</source>
   <translation>Die Hülle wurde nicht vereinfacht: Der Text in Klammern sagt, warum.</translation>
  </message>
  <message>
   <source>The envelope was simplified less than the tolerance allows; it has more triangles than necessary.</source>
   <translation>Die Hülle wurde weniger vereinfacht, als die Toleranz erlaubt; sie hat mehr Dreiecke als nötig.</translation>
  </message>
  <message>
   <source>Intersections between triangles were not checked.</source>
   <translation>Durchdringungen zwischen Dreiecken wurden nicht geprüft.</translation>
  </message>
 </context>
 <context>
  <name>SweptVolume_Messages</name>
  <message>
   <source>Open a document first.</source>
   <translation>Öffnen Sie zuerst ein Dokument.</translation>
  </message>
  <message>
   <source>The motion has no source whose settings can be changed.</source>
   <translation>Die Bewegung hat keine Quelle, deren Einstellungen geändert werden können.</translation>
  </message>
  <message>
   <source>There is no check in the document: make one with Check clearance or Check mechanism.</source>
   <translation>Im Dokument ist keine Prüfung: Legen Sie eine an mit Abstand prüfen oder Mechanismus prüfen.</translation>
  </message>
  <message>
   <source>Select one of the {0} checks and studies.</source>
   <translation>Wählen Sie eine der {0} Prüfungen und Studien.</translation>
  </message>
  <message>
   <source>Select the part whose path is to be found.</source>
   <translation>Wählen Sie das Teil aus, dessen Bahn gefunden werden soll.</translation>
  </message>
  <message>
   <source>Select the part that moves together with the motion.</source>
   <translation>Wählen Sie das Teil, das sich bewegt, zusammen mit der Bewegung.</translation>
  </message>
  <message>
   <source>"{0}" has fewer than two keys, so there is no path to improve: add a key.</source>
   <translation>„{0}“ hat weniger als zwei Stützstellen, es gibt also keine Bahn zu verbessern: Fügen Sie eine Stützstelle hinzu.</translation>
  </message>
  <message>
   <source>Select the object with the value, and the part that it moves.</source>
   <translation>Das Objekt mit dem Wert auswählen und das Teil, das er bewegt.</translation>
  </message>
  <message>
   <source>Select the object whose value is driven (spreadsheet, sketch, variables), then the part that it moves.</source>
   <translation>Das Objekt wählen, dessen Wert gesteuert wird (Tabelle, Skizze, Variablen), dann das Teil, das es bewegt.</translation>
  </message>
  <message>
   <source>Select at least two objects whose placements are the poses.</source>
   <translation>Wählen Sie mindestens zwei Objekte aus, deren Platzierungen die Lagen sind.</translation>
  </message>
  <message>
   <source>Select at least two objects whose placements are the poses, in the order of the motion: copies or links of the part, or local coordinate systems.</source>
   <translation>Mindestens zwei Objekte auswählen, deren Platzierungen die Lagen sind, in der Reihenfolge der Bewegung: Kopien oder Verknüpfungen des Teils oder lokale Koordinatensysteme.</translation>
  </message>
  <message>
   <source>Select a wire, sketch, array, CAM operation or robot trajectory, or a simulation and a part.</source>
   <translation>Wählen Sie einen Linienzug, eine Skizze, Anordnung, CAM-Operation oder Roboterbahn aus, oder eine Simulation und ein Teil.</translation>
  </message>
  <message>
   <source>Select one wire, sketch, robot trajectory, link array, Draft array or CAM operation; or two curves; or an assembly simulation and the part to follow.</source>
   <translation>Wählen Sie einen Linienzug, eine Skizze, Roboterbahn, Link-Anordnung, Draft-Anordnung oder CAM-Operation; oder zwei Kurven; oder eine Baugruppen-Simulation und das zu verfolgende Teil.</translation>
  </message>
  <message>
   <source>No envelope is stale. Select one to compute it again.</source>
   <translation>Keine Hülle ist veraltet. Eine auswählen, um sie neu zu berechnen.</translation>
  </message>
  <message>
   <source>there is no moving part: select a solid or a mesh, then press Add selected.</source>
   <translation>Es gibt kein bewegtes Teil: Wählen Sie einen Festkörper oder ein Netz und drücken Sie „Auswahl hinzufügen“.</translation>
  </message>
  <message>
   <source>the link "{0}" is empty: its target was deleted, or the document of the target is not open. Open that document, or choose another target.</source>
   <translation>Die Verknüpfung „{0}“ ist leer: Ihr Ziel wurde gelöscht, oder dessen Dokument ist nicht geöffnet. Öffnen Sie dieses Dokument, oder wählen Sie ein anderes Ziel.</translation>
  </message>
  <message>
   <source>"{0}" contains neither a solid nor a mesh: choose another object.</source>
   <translation>„{0}“ enthält weder Festkörper noch Netz: Wählen Sie ein anderes Objekt.</translation>
  </message>
  <message>
   <source>the moving part is empty: choose a part with a shape or a mesh.</source>
   <translation>Das bewegte Teil ist leer: Wählen Sie ein Teil mit einer Form oder einem Netz.</translation>
  </message>
  <message>
   <source>the shape could not be meshed: check it with Part &gt; Check geometry.</source>
   <translation>Die Form ließ sich nicht vernetzen: Prüfen Sie sie mit Part &gt; Geometrie überprüfen.</translation>
  </message>
  <message>
   <source>the shape has {0} faces but no solid: convert it with Part &gt; Convert to solid or Part &gt; Shape builder, or choose a closed mesh.</source>
   <translation>Die Form hat {0} Flächen, aber keinen Festkörper: Wandeln Sie sie mit Part &gt; In Festkörper umwandeln oder dem Formgenerator um, oder wählen Sie ein geschlossenes Netz.</translation>
  </message>
  <message>
   <source>"{0}" no longer leads to an object: choose the part again.</source>
   <translation>„{0}“ führt zu keinem Objekt mehr: Wählen Sie das Teil neu.</translation>
  </message>
  <message>
   <source>The compiled core of Swept Volume (_swept, for Python {0}) cannot be loaded.
Build it once, in the folder {1}:
    cmake --preset release &amp;&amp; cmake --build build
README.md lists the packages this needs. A core that lies elsewhere is named by the environment variable SWEPT_CORE.
Tried:
  {2}</source>
   <translation>Der übersetzte Kern von Swept Volume (_swept, für Python {0}) kann nicht geladen werden.
Einmal bauen, im Ordner {1}:
    cmake --preset release &amp;&amp; cmake --build build
README.md nennt die nötigen Pakete. Liegt der Kern woanders, nennt ihn die Umgebungsvariable SWEPT_CORE.
Versucht:
  {2}</translation>
  </message>
  <message>
   <source>The compiled core of Swept Volume in {0} is of version {1}, the workbench of version {2}: install both of the same version, or build the core again in the folder {3}:
    cmake --preset release &amp;&amp; cmake --build build</source>
   <translation>Der kompilierte Kern von Swept Volume in {0} hat die Version {1}, die Arbeitsumgebung die Version {2}: Installieren Sie beide in derselben Version, oder bauen Sie den Kern im Ordner {3} neu:
    cmake --preset release &amp;&amp; cmake --build build</translation>
  </message>
  <message>
   <source>Neighbours</source>
   <translation>Nachbarn</translation>
  </message>
  <message>
   <source>Installation path</source>
   <translation>Einbaubahn</translation>
  </message>
  <message>
   <source>Demo</source>
   <translation>Beispiel</translation>
  </message>
  <message>
   <source>Starter motor</source>
   <translation>Anlasser</translation>
  </message>
  <message>
   <source>Bell housing</source>
   <translation>Getriebeglocke</translation>
  </message>
  <message>
   <source>Flywheel</source>
   <translation>Schwungrad</translation>
  </message>
  <message>
   <source>Engine block and pan</source>
   <translation>Motorblock und Wanne</translation>
  </message>
  <message>
   <source>Exhaust pipe</source>
   <translation>Auspuffrohr</translation>
  </message>
  <message>
   <source>Frame rail</source>
   <translation>Rahmenträger</translation>
  </message>
  <message>
   <source>Not computed</source>
   <translation>Nicht berechnet</translation>
  </message>
  <message>
   <source>Up to date</source>
   <translation>Aktuell</translation>
  </message>
  <message>
   <source>Stale</source>
   <translation>Veraltet</translation>
  </message>
  <message>
   <source>Cancelled</source>
   <translation>Abgebrochen</translation>
  </message>
  <message>
   <source>Failed</source>
   <translation>Fehlgeschlagen</translation>
  </message>
  <message>
   <source>Clear</source>
   <translation>Frei</translation>
  </message>
  <message>
   <source>Below required</source>
   <translation>Unter Sollabstand</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>Kontakt</translation>
  </message>
  <message>
   <source>Clash</source>
   <translation>Kollision</translation>
  </message>
  <message>
   <source>Check clearance</source>
   <translation>Abstand prüfen</translation>
  </message>
  <message>
   <source>Clearance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>the rules ignore every neighbour: change at least one rule.</source>
   <translation>Die Regeln übergehen jeden Nachbarn: Ändern Sie mindestens eine Regel.</translation>
  </message>
  <message>
   <source>{0} also moved when this motion was read, but stand still in this check: use Check mechanism for parts that move at the same time.</source>
   <translation>{0} bewegten sich beim Lesen dieser Bewegung ebenfalls, stehen aber in dieser Prüfung still: Verwenden Sie „Mechanismus prüfen“ für Teile, die sich gleichzeitig bewegen.</translation>
  </message>
  <message>
   <source>"{0}" is not an envelope: choose an envelope.</source>
   <translation>„{0}“ ist keine Hülle: Wählen Sie eine Hülle.</translation>
  </message>
  <message>
   <source>the parts of "{0}" have individual motions: use Check mechanism, or check each part with its motion.</source>
   <translation>Die Teile von „{0}“ haben eigene Bewegungen: Verwenden Sie „Mechanismus prüfen“, oder prüfen Sie jedes Teil mit seiner Bewegung.</translation>
  </message>
  <message>
   <source>ignored</source>
   <translation>übergangen</translation>
  </message>
  <message>
   <source>contact</source>
   <translation>Kontakt</translation>
  </message>
  <message>
   <source>smallest {0} at t = {1} s ({2})</source>
   <translation>kleinster Abstand {0} bei t = {1} s ({2})</translation>
  </message>
  <message>
   <source>smallest {0}, at least {1}, at t = {2} s ({3})</source>
   <translation>kleinster Abstand {0}, mindestens {1}, bei t = {2} s ({3})</translation>
  </message>
  <message>
   <source>contact, {0} deep</source>
   <translation>Kontakt, {0} tief</translation>
  </message>
  <message>
   <source>{0} clash</source>
   <translation>{0} kollidieren</translation>
  </message>
  <message>
   <source>{0} in contact</source>
   <translation>{0} in Kontakt</translation>
  </message>
  <message>
   <source>{0} below required</source>
   <translation>{0} unter Sollabstand</translation>
  </message>
  <message>
   <source>{0} in allowed contact</source>
   <translation>{0} in erlaubtem Kontakt</translation>
  </message>
  <message>
   <source>{0} ignored</source>
   <translation>{0} übergangen</translation>
  </message>
  <message>
   <source>deepest {0} at t = {1} s ({2})</source>
   <translation>tiefste Kollision {0} bei t = {1} s ({2})</translation>
  </message>
  <message>
   <source>{0} table</source>
   <translation>{0} Tabelle</translation>
  </message>
  <message>
   <source>{0} checked</source>
   <translation>{0} geprüft</translation>
  </message>
  <message>
   <source>Compute envelope</source>
   <translation>Hülle berechnen</translation>
  </message>
  <message>
   <source>Envelope</source>
   <translation>Hülle</translation>
  </message>
  <message>
   <source>cavities cannot be kept if parts have individual motions: create one envelope for each motion.</source>
   <translation>Hohlräume können nicht erhalten bleiben, wenn Teile eigene Bewegungen haben: Erzeugen Sie für jede Bewegung eine eigene Hülle.</translation>
  </message>
  <message>
   <source>the number of individual motions ({1}) is not that of the moving parts ({0}): give one motion for each part, or none.</source>
   <translation>Die Anzahl der eigenen Bewegungen ({1}) ist nicht die der bewegten Teile ({0}): Geben Sie für jedes Teil eine Bewegung an oder keine.</translation>
  </message>
  <message>
   <source>the core was built without OpenCASCADE, so FreeCAD made one face for each triangle and recognised no surfaces</source>
   <translation>der Rechenkern wurde ohne OpenCASCADE gebaut, daher hat FreeCAD aus jedem Dreieck eine Fläche gemacht und keine Flächen erkannt</translation>
  </message>
  <message>
   <source>FreeCAD could not make a valid solid from this envelope: build the core with OpenCASCADE, or export a mesh file.</source>
   <translation>FreeCAD konnte aus dieser Hülle keinen gültigen Festkörper machen: Bauen Sie den Rechenkern mit OpenCASCADE, oder exportieren Sie eine Netzdatei.</translation>
  </message>
  <message>
   <source>the core was built without OpenCASCADE, and {0} triangles would become as many faces (limit {1}): simplify the envelope, or export STL, PLY or OBJ.</source>
   <translation>der Rechenkern wurde ohne OpenCASCADE gebaut, und aus {0} Dreiecken würden ebenso viele Flächen (Grenze {1}): die Hülle vereinfachen oder als STL, PLY oder OBJ exportieren.</translation>
  </message>
  <message>
   <source>{0}, improved</source>
   <translation>{0}, verbessert</translation>
  </message>
  <message>
   <source>there is no neighbour: choose parts, or make other parts visible.</source>
   <translation>Es gibt keinen Nachbarn: Wählen Sie Teile, oder blenden Sie andere ein.</translation>
  </message>
  <message>
   <source>"{0}" has the interpolation None: choose another interpolation first.</source>
   <translation>„{0}“ hat die Interpolation „Keine“: Wählen Sie zuerst eine andere Interpolation.</translation>
  </message>
  <message>
   <source>"{0}" moves no visible part: show the parts, or choose another source.</source>
   <translation>„{0}“ bewegt kein sichtbares Teil: die Teile zeigen oder eine andere Quelle wählen.</translation>
  </message>
  <message>
   <source>"{0}" is left out, because it is only visible through a link: add its parts to the assembly itself.</source>
   <translation>„{0}“ wird ausgelassen, weil es nur durch eine Verknüpfung sichtbar ist: Fügen Sie seine Teile der Baugruppe selbst hinzu.</translation>
  </message>
  <message>
   <source>Check mechanism</source>
   <translation>Mechanismus prüfen</translation>
  </message>
  <message>
   <source>Mechanism</source>
   <translation>Mechanismus</translation>
  </message>
  <message>
   <source>the number of motions ({1}) is not that of the moving parts ({0}): give one motion for each part.</source>
   <translation>Die Anzahl der Bewegungen ({1}) ist nicht die der bewegten Teile ({0}): Geben Sie für jedes Teil eine Bewegung an.</translation>
  </message>
  <message>
   <source>the motions have no common time: "{0}" ends at {1} s, and "{2}" begins at {3} s. Change their times so that they overlap.</source>
   <translation>Die Bewegungen haben keine gemeinsame Zeit: „{0}“ endet bei {1} s, und „{2}“ beginnt bei {3} s. Ändern Sie ihre Zeiten so, dass sie sich überschneiden.</translation>
  </message>
  <message>
   <source>the document changed while its parts were read: start the run again.</source>
   <translation>Das Dokument hat sich geändert, während seine Teile gelesen wurden: Starten Sie den Lauf noch einmal.</translation>
  </message>
  <message>
   <source>"{0}" has no motion: choose one in the table.</source>
   <translation>„{0}“ hat keine Bewegung: Wählen Sie eine in der Tabelle.</translation>
  </message>
  <message>
   <source>"{0}" is in the list twice: remove one entry.</source>
   <translation>„{0}“ steht zweimal in der Liste: Entfernen Sie einen Eintrag.</translation>
  </message>
  <message>
   <source>"{0}" and "{1}": one contains the other, which would move twice. Remove one of them.</source>
   <translation>„{0}“ und „{1}“: Eines enthält das andere, das sich zweimal bewegen würde. Entfernen Sie eines davon.</translation>
  </message>
  <message>
   <source>"{0}" has the interpolation None, but parts that move at the same time must move between their poses: choose another interpolation.</source>
   <translation>„{0}“ hat die Interpolation „Keine“, aber Teile, die sich gleichzeitig bewegen, müssen sich zwischen ihren Lagen bewegen: Wählen Sie eine andere Interpolation.</translation>
  </message>
  <message>
   <source>only one part is given: add a second part, moving or standing still.</source>
   <translation>Nur ein Teil ist angegeben: Fügen Sie ein zweites hinzu, bewegt oder stillstehend.</translation>
  </message>
  <message>
   <source>{0}, none nearer than {1}</source>
   <translation>{0}, keines näher als {1}</translation>
  </message>
  <message>
   <source>{0} pairs checked</source>
   <translation>{0} Paare geprüft</translation>
  </message>
  <message>
   <source>{0} was deleted, and {1} needs it: choose a replacement ({2}), or undo the deletion.</source>
   <translation>{0} wurde gelöscht, und {1} braucht es: Wählen Sie einen Ersatz ({2}), oder machen Sie das Löschen rückgängig.</translation>
  </message>
  <message>
   <source>no poses yet</source>
   <translation>noch keine Lagen</translation>
  </message>
  <message>
   <source>Motion</source>
   <translation>Bewegung</translation>
  </message>
  <message>
   <source>Motion of {0}</source>
   <translation>Bewegung von {0}</translation>
  </message>
  <message>
   <source>the steps of "{0}" are large: near {1} s the part may deviate from its true motion by about {2}. Read the motion with smaller steps.</source>
   <translation>Die Schritte von „{0}“ sind groß: Bei {1} s kann das Teil um etwa {2} von seiner wahren Bewegung abweichen. Lesen Sie die Bewegung mit kleineren Schritten.</translation>
  </message>
  <message>
   <source>there is no motion: make one with New motion, then choose it.</source>
   <translation>Es gibt keine Bewegung: Legen Sie eine mit „Neue Bewegung“ an, und wählen Sie sie.</translation>
  </message>
  <message>
   <source>the reference part has no motion: choose its motion, or clear the reference part.</source>
   <translation>Das Bezugsteil hat keine Bewegung: Wählen Sie seine Bewegung, oder entfernen Sie das Bezugsteil.</translation>
  </message>
  <message>
   <source>there is a reference motion but no reference part: choose the reference part as well.</source>
   <translation>Es gibt eine Bezugsbewegung, aber kein Bezugsteil: Wählen Sie auch das Bezugsteil.</translation>
  </message>
  <message>
   <source>"{0}" is not a motion: choose a motion.</source>
   <translation>„{0}“ ist keine Bewegung: Wählen Sie eine Bewegung.</translation>
  </message>
  <message>
   <source>two rules for "{0}" contradict each other: remove one.</source>
   <translation>Zwei Regeln für „{0}“ widersprechen einander: Entfernen Sie eine.</translation>
  </message>
  <message>
   <source>"{0}": there is no rule "{1}"; use Required, Contact or Ignore.</source>
   <translation>„{0}“: Es gibt keine Regel „{1}“; verwenden Sie Required, Contact oder Ignore.</translation>
  </message>
  <message>
   <source>"{0}": a rule cannot have a length of {1} mm; enter 0 or more.</source>
   <translation>„{0}“: Eine Regel kann keine Länge von {1} mm haben; geben Sie 0 oder mehr ein.</translation>
  </message>
  <message>
   <source>the rules of "{0}" are inconsistent: {1} parts, {2} kinds and {3} lengths, which must be equal in number. Enter the rules again.</source>
   <translation>Die Regeln von „{0}“ sind widersprüchlich: {1} Teile, {2} Arten und {3} Längen, deren Anzahl gleich sein muss. Geben Sie die Regeln neu ein.</translation>
  </message>
  <message>
   <source>there is nothing to compare: choose two or more parts, envelopes or solids.</source>
   <translation>Es gibt nichts zu vergleichen: Wählen Sie zwei oder mehr Teile, Hüllen oder Festkörper.</translation>
  </message>
  <message>
   <source>"{0}" contains "{1}": remove one of them.</source>
   <translation>„{0}“ enthält „{1}“: Entfernen Sie eines davon.</translation>
  </message>
  <message>
   <source>the rules for "{0}" and for "{1}" contradict each other for "{2}", and neither is more specific: add a rule for this pair.</source>
   <translation>Die Regeln für „{0}“ und für „{1}“ widersprechen sich für „{2}“, und keine ist spezieller: Fügen Sie eine Regel für dieses Paar hinzu.</translation>
  </message>
  <message>
   <source>the rules of "{0}" are inconsistent: {1} parts (two for each rule), {2} kinds and {3} lengths. Enter the rules again.</source>
   <translation>Die Regeln von „{0}“ sind widersprüchlich: {1} Teile (zwei je Regel), {2} Arten und {3} Längen. Geben Sie die Regeln neu ein.</translation>
  </message>
  <message>
   <source>Path of {0}</source>
   <translation>Bahn von {0}</translation>
  </message>
  <message>
   <source>there is no start: give a placement, a distance or a direction.</source>
   <translation>Es gibt keinen Start: Geben Sie eine Platzierung, einen Abstand oder eine Richtung an.</translation>
  </message>
  <message>
   <source>Check sequence</source>
   <translation>Einbaufolge prüfen</translation>
  </message>
  <message>
   <source>{0} of {1} parts have a path</source>
   <translation>{0} von {1} Teilen haben eine Bahn</translation>
  </message>
  <message>
   <source>clearance at least {0}</source>
   <translation>Abstand mindestens {0}</translation>
  </message>
  <message>
   <source>proven: no path without turning</source>
   <translation>bewiesen: keine Bahn ohne Drehung</translation>
  </message>
  <message>
   <source>Sequence</source>
   <translation>Einbaufolge</translation>
  </message>
  <message>
   <source>{0} parts one after the other: {1}</source>
   <translation>{0} Teile nacheinander: {1}</translation>
  </message>
  <message>
   <source>no path; blocked after {0} by {1}</source>
   <translation>keine Bahn; nach {0} blockiert von {1}</translation>
  </message>
  <message>
   <source>There is no order in which the parts can be installed one after the other (proven).</source>
   <translation>Es gibt keine Reihenfolge, in der die Teile nacheinander eingebaut werden können (bewiesen).</translation>
  </message>
  <message>
   <source>{0}, clearance {1}</source>
   <translation>{0}, Abstand {1}</translation>
  </message>
  <message>
   <source>{0}, no obstacles</source>
   <translation>{0}, keine Hindernisse</translation>
  </message>
  <message>
   <source>the number of motions ({1}) is not that of the parts ({0}): give one motion for each part.</source>
   <translation>Die Anzahl der Bewegungen ({1}) ist nicht die der Teile ({0}): Geben Sie für jedes Teil eine Bewegung an.</translation>
  </message>
  <message>
   <source>there is no part: select the parts, then press Add selected.</source>
   <translation>Es gibt kein Teil: Wählen Sie die Teile, und drücken Sie „Gewählte hinzufügen“.</translation>
  </message>
  <message>
   <source>"{0}" has the interpolation None: choose another interpolation, or let a path be found.</source>
   <translation>„{0}“ hat die Interpolation „Keine“: Wählen Sie eine andere Interpolation, oder lassen Sie eine Bahn finden.</translation>
  </message>
  <message>
   <source>They share no volume; the smallest distance is {0}.</source>
   <translation>Sie haben kein Volumen gemeinsam; der kleinste Abstand ist {0}.</translation>
  </message>
  <message>
   <source>Shared volume</source>
   <translation>Gemeinsames Volumen</translation>
  </message>
  <message>
   <source>a shared volume needs two sides: choose two parts or envelopes.</source>
   <translation>Ein gemeinsames Volumen braucht zwei Seiten: Wählen Sie zwei Teile oder Hüllen.</translation>
  </message>
  <message>
   <source>"{0}" is on both sides: choose another object for one of them.</source>
   <translation>„{0}“ steht auf beiden Seiten: Wählen Sie für eine davon ein anderes Objekt.</translation>
  </message>
  <message>
   <source>Make solid</source>
   <translation>Festkörper erzeugen</translation>
  </message>
  <message>
   <source>the envelope has no mesh yet: compute it first.</source>
   <translation>Die Hülle hat noch kein Netz: Berechnen Sie sie zuerst.</translation>
  </message>
  <message>
   <source>at one edge the faces of the solid have a gap of {0}, more than its deviation of {1} from the mesh. A smaller Tolerance gives more faces and smaller gaps.</source>
   <translation>An einer Kante haben die Flächen des Festkörpers einen Spalt von {0}, mehr als seine Abweichung von {1} vom Netz. Eine kleinere Toleranz gibt mehr Flächen und kleinere Spalte.</translation>
  </message>
  <message>
   <source>the envelope is conservative, but a solid with a tolerance could cut into the swept volume: set the Tolerance of the solid to 0.</source>
   <translation>Die Hülle ist konservativ, aber ein Festkörper mit Toleranz könnte in das überstrichene Volumen schneiden: Setzen Sie die Toleranz des Festkörpers auf 0.</translation>
  </message>
  <message>
   <source>{0} solid</source>
   <translation>{0} Festkörper</translation>
  </message>
  <message>
   <source>Checking whether large parts have changed ...</source>
   <translation>Große Teile werden auf Änderungen geprüft ...</translation>
  </message>
  <message>
   <source>Left out: {0}</source>
   <translation>Ausgelassen: {0}</translation>
  </message>
  <message>
   <source>Left out: {0}. Envelopes and their solids are only checked if you choose them as neighbours.</source>
   <translation>Ausgelassen: {0}. Hüllen und ihre Festkörper werden nur geprüft, wenn Sie sie als Nachbarn wählen.</translation>
  </message>
  <message>
   <source>"{0}" is both a neighbour and a moving part: remove it from one of the lists.</source>
   <translation>„{0}“ ist zugleich Nachbar und bewegtes Teil: Entfernen Sie es aus einer der Listen.</translation>
  </message>
  <message>
   <source>{0} of {1} runs are not done: start the study again to continue.</source>
   <translation>{0} von {1} Läufen sind nicht fertig: Starten Sie die Studie erneut, um fortzufahren.</translation>
  </message>
  <message>
   <source>the results of the study were deleted: run the study again.</source>
   <translation>Die Ergebnisse der Studie wurden gelöscht: Führen Sie die Studie erneut aus.</translation>
  </message>
  <message>
   <source>Run study</source>
   <translation>Studie rechnen</translation>
  </message>
  <message>
   <source>Study</source>
   <translation>Studie</translation>
  </message>
  <message>
   <source>the result of "{0}" is not up to date: run the study again first.</source>
   <translation>Das Ergebnis von „{0}“ ist nicht aktuell: Führen Sie die Studie zuerst erneut aus.</translation>
  </message>
  <message>
   <source>the parts of "{0}" have individual motions, but a run of a study has one motion: leave "{0}" out, or give its parts one motion.</source>
   <translation>Die Teile von „{0}“ haben eigene Bewegungen, aber ein Lauf einer Studie hat eine Bewegung: Lassen Sie „{0}“ aus, oder geben Sie seinen Teilen eine Bewegung.</translation>
  </message>
  <message>
   <source>"{0}": studies support only the value Consistent of the property Components.</source>
   <translation>„{0}“: Studien unterstützen nur den Wert Consistent der Eigenschaft Components.</translation>
  </message>
  <message>
   <source>the study file no longer contains the run "{0}": run the study again.</source>
   <translation>Die Studiendatei enthält den Lauf „{0}“ nicht mehr: Führen Sie die Studie erneut aus.</translation>
  </message>
  <message>
   <source>Run {0}</source>
   <translation>Lauf {0}</translation>
  </message>
  <message>
   <source>"{0}" cannot be a run of a study: choose envelopes and clearance checks of one motion.</source>
   <translation>„{0}“ kann kein Lauf einer Studie sein: Wählen Sie Hüllen und Abstandsprüfungen mit einer Bewegung.</translation>
  </message>
  <message>
   <source>the study has no runs: choose a study file, or envelopes and clearance checks.</source>
   <translation>Die Studie hat keine Läufe: Wählen Sie eine Studiendatei oder Hüllen und Abstandsprüfungen.</translation>
  </message>
  <message>
   <source>there is no folder for the results: save the document first, or choose a folder.</source>
   <translation>Es gibt keinen Ordner für die Ergebnisse: Speichern Sie zuerst das Dokument, oder wählen Sie einen Ordner.</translation>
  </message>
  <message>
   <source>Not clear</source>
   <translation>Nicht frei</translation>
  </message>
  <message>
   <source>Not run</source>
   <translation>Nicht gerechnet</translation>
  </message>
  <message>
   <source>Done</source>
   <translation>Fertig</translation>
  </message>
  <message>
   <source>Contact, allowed</source>
   <translation>Kontakt, erlaubt</translation>
  </message>
  <message>
   <source>{0} failed</source>
   <translation>{0} fehlgeschlagen</translation>
  </message>
  <message>
   <source>{0} not clear</source>
   <translation>{0} nicht frei</translation>
  </message>
  <message>
   <source>{0} not run</source>
   <translation>{0} nicht gerechnet</translation>
  </message>
  <message>
   <source>{0} done</source>
   <translation>{0} fertig</translation>
  </message>
  <message>
   <source>{0} deep</source>
   <translation>{0} tief</translation>
  </message>
  <message>
   <source>{0} runs</source>
   <translation>{0} Läufe</translation>
  </message>
  <message>
   <source>t = {0} s</source>
   <translation>t = {0} s</translation>
  </message>
  <message>
   <source>the report template "{0}" is empty: choose another one in the preferences.</source>
   <translation>Die Berichtsvorlage „{0}“ ist leer: Wählen Sie eine andere in den Einstellungen.</translation>
  </message>
  <message>
   <source>changed since it was saved</source>
   <translation>seit dem Speichern geändert</translation>
  </message>
  <message>
   <source>the result of "{0}" is not up to date: recompute its envelope, if it has one, and run the check again first.</source>
   <translation>Das Ergebnis von „{0}“ ist nicht aktuell: Berechnen Sie ihre Hülle neu, falls es eine gibt, und prüfen Sie zuerst erneut.</translation>
  </message>
  <message>
   <source>SOURCE_DATE_EPOCH is "{0}"; it must be seconds since 1970.</source>
   <translation>SOURCE_DATE_EPOCH ist „{0}“; es müssen Sekunden seit 1970 sein.</translation>
  </message>
  <message>
   <source>the report template "{0}" cannot be read ({1}): choose another one in the preferences.</source>
   <translation>Die Berichtsvorlage „{0}“ kann nicht gelesen werden ({1}): Wählen Sie eine andere in den Einstellungen.</translation>
  </message>
  <message>
   <source>{0} triangles</source>
   <translation>{0} Dreiecke</translation>
  </message>
  <message>
   <source>{0} poses</source>
   <translation>{0} Lagen</translation>
  </message>
  <message>
   <source>PDF needs the FreeCAD window: write HTML from scripts.</source>
   <translation>PDF braucht das FreeCAD-Fenster: Schreiben Sie aus Skripten HTML.</translation>
  </message>
  <message>
   <source>document</source>
   <translation>Dokument</translation>
  </message>
  <message>
   <source>Clearance table</source>
   <translation>Abstandstabelle</translation>
  </message>
  <message>
   <source>the envelope is relative to a moving part, so its clash volume has no place in the document: check without a reference part.</source>
   <translation>Die Hülle ist relativ zu einem bewegten Teil, ihr Kollisionsvolumen hat daher keinen Ort im Dokument: Prüfen Sie ohne Bezugsteil.</translation>
  </message>
  <message>
   <source>the cell size must be above 0 mm.</source>
   <translation>Die Zellgröße muss über 0 mm liegen.</translation>
  </message>
  <message>
   <source>Motion from file</source>
   <translation>Bewegung aus Datei</translation>
  </message>
  <message>
   <source>select the part that moves in the tree or in the 3D view.</source>
   <translation>wählen Sie das Teil, das sich bewegt, im Baum oder in der 3D-Ansicht.</translation>
  </message>
  <message>
   <source>{0}: "{1}" is not a valid value; {2} is used instead.</source>
   <translation>{0}: „{1}“ ist kein gültiger Wert; stattdessen gilt {2}.</translation>
  </message>
  <message>
   <source>Made by cannot be recorded for an envelope with an offset or a conservative one: set Offset to 0 and Conservative to off.</source>
   <translation>„Erzeugt von“ kann bei einer Hülle mit Versatz oder einer konservativen Hülle nicht aufgezeichnet werden: Setzen Sie den Versatz auf 0, und schalten Sie „Konservativ“ aus.</translation>
  </message>
  <message>
   <source>Transform is locked while the motion editor is open: drag the chosen key, or enter numbers.</source>
   <translation>Transformieren ist gesperrt, solange der Bewegungseditor offen ist: Ziehen Sie die gewählte Stützstelle, oder geben Sie Zahlen ein.</translation>
  </message>
  <message>
   <source>there is no change of the keys to undo or redo.</source>
   <translation>Es gibt keine Änderung der Stützstellen, die rückgängig gemacht oder wiederholt werden kann.</translation>
  </message>
  <message>
   <source>there is no moving part: close the panel, select the part and open the panel again.</source>
   <translation>Es gibt kein bewegtes Teil: Schließen Sie das Panel, wählen Sie das Teil, und öffnen Sie das Panel neu.</translation>
  </message>
  <message>
   <source>only absolute poses can be captured: set Pose type to Absolute.</source>
   <translation>Nur absolute Lagen können übernommen werden: Stellen Sie die Art der Lage auf „Absolut“.</translation>
  </message>
  <message>
   <source>choose a key in the table first.</source>
   <translation>Wählen Sie zuerst eine Stützstelle in der Tabelle.</translation>
  </message>
  <message>
   <source>Edit motion</source>
   <translation>Bewegung bearbeiten</translation>
  </message>
  <message>
   <source>Motions of all parts</source>
   <translation>Bewegungen aller Teile</translation>
  </message>
  <message>
   <source>the motion "{0}" has no part: add the part to the list, then choose the motion for it.</source>
   <translation>Die Bewegung „{0}“ hat kein Teil: Fügen Sie das Teil der Liste hinzu, und wählen Sie dann die Bewegung dafür.</translation>
  </message>
  <message>
   <source>Export report</source>
   <translation>Bericht exportieren</translation>
  </message>
  <message>
   <source>Written: {0} ({1})
</source>
   <translation>Geschrieben: {0} ({1})
</translation>
  </message>
  <message>
   <source>The part moved {0} from its goal before it was blocked; it is shown there.</source>
   <translation>Das Teil bewegte sich {0} von seinem Ziel weg, bevor es blockiert war; dort wird es gezeigt.</translation>
  </message>
  <message>
   <source>Most frequent obstacle: {0}.</source>
   <translation>Häufigstes Hindernis: {0}.</translation>
  </message>
  <message>
   <source>A path exists with a clearance of {0}: reduce the required distance to find it.</source>
   <translation>Mit einem Abstand von {0} gibt es eine Bahn: Verringern Sie den Sollabstand, um sie zu finden.</translation>
  </message>
  <message>
   <source>{0} keys instead of {1}, {2} instead of {3}, clearance {4} instead of {5}.</source>
   <translation>{0} Stützstellen statt {1}, {2} statt {3}, Abstand {4} statt {5}.</translation>
  </message>
  <message>
   <source>There is no path without turning the part (proven).</source>
   <translation>Es gibt keine Bahn ohne Drehung des Teils (bewiesen).</translation>
  </message>
  <message>
   <source>No move of the motion keeps the required distance: reduce the required distance, or use Find path.</source>
   <translation>Kein Abschnitt der Bewegung hält den Sollabstand ein: Verringern Sie den Sollabstand, oder verwenden Sie „Bahn finden“.</translation>
  </message>
  <message>
   <source>Moves that stay below the required distance, because no other path was found: {0}.</source>
   <translation>Abschnitte, die unter dem Sollabstand bleiben, weil keine andere Bahn gefunden wurde: {0}.</translation>
  </message>
  <message>
   <source>Moves within the release distance of start and goal, which are left unchanged: {0}.</source>
   <translation>Abschnitte innerhalb des Freigabeabstands von Start und Ziel, die unverändert bleiben: {0}.</translation>
  </message>
  <message>
   <source>Found: {0} keys, {1}, turns of {2} degrees, clearance at least {3}.</source>
   <translation>Gefunden: {0} Stützstellen, {1}, Drehungen von {2} Grad, Abstand mindestens {3}.</translation>
  </message>
  <message>
   <source>Nearer than that within the release distance of {0}, as allowed: {1}.</source>
   <translation>Näher als das innerhalb des Freigabeabstands von {0}, wie erlaubt: {1}.</translation>
  </message>
  <message>
   <source>No path was found within the time limit.</source>
   <translation>Innerhalb der Zeitgrenze wurde keine Bahn gefunden.</translation>
  </message>
  <message>
   <source>No path was found.</source>
   <translation>Es wurde keine Bahn gefunden.</translation>
  </message>
  <message>
   <source>A path exists only with a clearance near 0: reduce the required distance to find it.</source>
   <translation>Nur mit einem Abstand nahe 0 gibt es eine Bahn: Verringern Sie den Sollabstand, um sie zu finden.</translation>
  </message>
  <message>
   <source>select a vertex, an edge or a face in the 3D view first: its centre becomes the pivot.</source>
   <translation>wählen Sie zuerst in der 3D-Ansicht einen Punkt, eine Kante oder eine Fläche: deren Mitte wird der Drehpunkt.</translation>
  </message>
  <message>
   <source>select a face or an edge in the 3D view first: it gives the direction.</source>
   <translation>wählen Sie zuerst eine Fläche oder Kante in der 3D-Ansicht: sie gibt die Richtung.</translation>
  </message>
  <message>
   <source>"{0}": enter {1} numbers, separated by spaces.</source>
   <translation>„{0}“: Geben Sie {1} Zahlen ein, durch Leerzeichen getrennt.</translation>
  </message>
  <message>
   <source>a part of this row was deleted: run the check again.</source>
   <translation>Ein Teil dieser Zeile wurde gelöscht: Prüfen Sie erneut.</translation>
  </message>
  <message>
   <source>"{0}": the distance cannot be {1}; enter 0 or more.</source>
   <translation>„{0}“: Der Abstand kann nicht {1} sein; geben Sie 0 oder mehr ein.</translation>
  </message>
  <message>
   <source>There is no envelope in the document: make one with Create envelope.</source>
   <translation>Im Dokument gibt es keine Hülle: Erzeugen Sie eine mit Hülle erzeugen.</translation>
  </message>
  <message>
   <source>Select one of the {0} envelopes.</source>
   <translation>Wählen Sie eine der {0} Hüllen aus.</translation>
  </message>
  <message>
   <source>There is no motion in the document: make one with New motion.</source>
   <translation>Im Dokument gibt es keine Bewegung: Legen Sie eine mit Neue Bewegung an.</translation>
  </message>
  <message>
   <source>Select one of the {0} motions.</source>
   <translation>Wählen Sie eine der {0} Bewegungen aus.</translation>
  </message>
  <message>
   <source>Select an envelope first.</source>
   <translation>Zuerst eine Hülle auswählen.</translation>
  </message>
  <message>
   <source>Select a motion first.</source>
   <translation>Zuerst eine Bewegung auswählen.</translation>
  </message>
  <message>
   <source>no program is installed that opens {0}.</source>
   <translation>Es ist kein Programm installiert, das {0} öffnet.</translation>
  </message>
  <message>
   <source>Open run</source>
   <translation>Lauf öffnen</translation>
  </message>
  <message>
   <source>Look for contacts</source>
   <translation>Kontakte suchen</translation>
  </message>
  <message>
   <source>Export envelope</source>
   <translation>Hülle exportieren</translation>
  </message>
  <message>
   <source>Check reserved spaces</source>
   <translation>Reservierte Räume prüfen</translation>
  </message>
  <message>
   <source>Read parts</source>
   <translation>Teile lesen</translation>
  </message>
  <message>
   <source>{0} triangles, {1}, {2}</source>
   <translation>{0} Dreiecke, {1}, {2}</translation>
  </message>
  <message>
   <source>Cancelled. Nothing was changed.</source>
   <translation>Abgebrochen. Nichts wurde geändert.</translation>
  </message>
  <message>
   <source>Cancelled: the document was closed, or an object was deleted.</source>
   <translation>Abgebrochen: Das Dokument wurde geschlossen oder ein Objekt gelöscht.</translation>
  </message>
  <message>
   <source>the temporary folder {0} is full: free some space, or set the environment variable TMPDIR to another folder.</source>
   <translation>Der temporäre Ordner {0} ist voll: Schaffen Sie dort Platz, oder setzen Sie die Umgebungsvariable TMPDIR auf einen anderen Ordner.</translation>
  </message>
  <message>
   <source>studies need the Python package swept_volume, which is missing in {0}: install the workbench again, or build it with cmake --build build.</source>
   <translation>Studien brauchen das Python-Paket swept_volume, das in {0} fehlt: Installieren Sie die Arbeitsumgebung neu, oder bauen Sie sie mit cmake --build build.</translation>
  </message>
  <message>
   <source>the study ended with status {0} and without a result: run it again, or run it with swept study to see its output.</source>
   <translation>Die Studie endete mit Status {0} und ohne Ergebnis: Führen Sie sie erneut aus, oder mit swept study, um ihre Ausgabe zu sehen.</translation>
  </message>
  <message>
   <source>studies need the program {0}, which was not found: install it.</source>
   <translation>Studien brauchen das Programm {0}, das nicht gefunden wurde: Installieren Sie es.</translation>
  </message>
  <message>
   <source>study files cannot be read: {0}</source>
   <translation>Studiendateien können nicht gelesen werden: {0}</translation>
  </message>
  <message>
   <source>the study file "{0}" cannot be read: {1}</source>
   <translation>die Studiendatei „{0}“ kann nicht gelesen werden: {1}</translation>
  </message>
  <message>
   <source>the file type "{0}" is not supported: use one of {1}.</source>
   <translation>Der Dateityp „{0}“ wird nicht unterstützt: Verwenden Sie einen von {1}.</translation>
  </message>
  <message>
   <source>"{0}" is the document "{1}": choose another file.</source>
   <translation>„{0}“ ist das Dokument „{1}“: Wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>the folder "{0}" does not exist: create it, or choose another one.</source>
   <translation>Der Ordner „{0}“ existiert nicht: Legen Sie ihn an, oder wählen Sie einen anderen.</translation>
  </message>
  <message>
   <source>"{0}" is a folder: enter the name of a file.</source>
   <translation>„{0}“ ist ein Ordner: Geben Sie den Namen einer Datei an.</translation>
  </message>
  <message>
   <source>"{0}" is write-protected: choose another name, or change its permissions.</source>
   <translation>„{0}“ ist schreibgeschützt: Wählen Sie einen anderen Namen, oder ändern Sie die Rechte.</translation>
  </message>
  <message>
   <source>"{0}" is read by "{1}": choose another file.</source>
   <translation>„{0}“ wird von „{1}“ gelesen: Wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>en</source>
   <translation>de</translation>
  </message>
  <message>
   <source>choose one link array or Draft array.</source>
   <translation>Eine Verknüpfungs- oder Draft-Anordnung wählen.</translation>
  </message>
  <message>
   <source>choose an assembly simulation, then the part to follow.</source>
   <translation>Wählen Sie eine Baugruppen-Simulation, dann das zu verfolgende Teil.</translation>
  </message>
  <message>
   <source>the simulation "{0}" stopped early, at {3} s of {4} s ({1} of {2} frames), because its solver found no valid position: check the joints and formulas, or set an earlier end time.</source>
   <translation>Die Simulation „{0}“ endete vorzeitig, bei {3} s von {4} s ({1} von {2} Bildern), weil ihr Löser keine gültige Lage fand: Prüfen Sie Gelenke und Formeln, oder setzen Sie ein früheres Ende.</translation>
  </message>
  <message>
   <source>"{0}" cannot be simulated by this version of FreeCAD: simulations need FreeCAD 1.1.</source>
   <translation>„{0}“ kann von dieser FreeCAD-Version nicht simuliert werden: Simulationen brauchen FreeCAD 1.1.</translation>
  </message>
  <message>
   <source>choose one CAM (Path) operation.</source>
   <translation>Wählen Sie eine CAM-Operation (Path).</translation>
  </message>
  <message>
   <source>"{0}" has no moves (G0 to G3): choose another operation.</source>
   <translation>„{0}“ hat keine Fahrbewegungen (G0 bis G3): Wählen Sie eine andere Operation.</translation>
  </message>
  <message>
   <source>the motion file "{0}" does not exist: choose another file.</source>
   <translation>Die Bewegungsdatei „{0}“ existiert nicht: Wählen Sie eine andere.</translation>
  </message>
  <message>
   <source>a curve needs at least two poses: set Count to 0, or to 2 or more.</source>
   <translation>Eine Kurve braucht mindestens zwei Lagen: Setzen Sie die Anzahl auf 0 oder auf mindestens 2.</translation>
  </message>
  <message>
   <source>choose two wires: the curve to follow, then the curve that sets the orientation.</source>
   <translation>Wählen Sie zwei Linienzüge: die Leitkurve, dann die Kurve für die Ausrichtung.</translation>
  </message>
  <message>
   <source>choose one wire, edge or sketch to follow.</source>
   <translation>Wählen Sie einen Linienzug, eine Kante oder eine Skizze als Leitkurve.</translation>
  </message>
  <message>
   <source>the accuracy is {0}, but must be greater than 0.</source>
   <translation>Die Genauigkeit ist {0}, muss aber größer als 0 sein.</translation>
  </message>
  <message>
   <source>"{0}" has {1} separate pieces: join them to one curve, or select one piece.</source>
   <translation>„{0}“ hat {1} getrennte Stücke: Verbinden Sie sie zu einer Kurve, oder wählen Sie ein Stück.</translation>
  </message>
  <message>
   <source>an accuracy of {0} needs more than {1} poses on this curve: choose a larger accuracy value.</source>
   <translation>Eine Genauigkeit von {0} braucht auf dieser Kurve mehr als {1} Lagen: Wählen Sie einen größeren Wert.</translation>
  </message>
  <message>
   <source>"{0}" starts in the direction of the curve "{1}", so it does not define the z axis: move it sideways.</source>
   <translation>„{0}“ beginnt in Richtung der Kurve „{1}“ und legt so die z-Achse nicht fest: Versetzen Sie sie seitlich.</translation>
  </message>
  <message>
   <source>the document cannot be recomputed with "{0}" = {1:g}: choose another start or end.</source>
   <translation>Das Dokument lässt sich mit „{0}“ = {1:g} nicht neu berechnen: Wählen Sie einen anderen Start oder ein anderes Ende.</translation>
  </message>
  <message>
   <source>choose the object whose value is driven, then the part to follow.</source>
   <translation>Wählen Sie das Objekt, dessen Wert gesteuert wird, dann das zu verfolgende Teil.</translation>
  </message>
  <message>
   <source>"{0}" has no value "{1}" that can be driven: choose one of {2}</source>
   <translation>„{0}“ hat keinen steuerbaren Wert „{1}“: Wählen Sie einen von {2}</translation>
  </message>
  <message>
   <source>"{0}" of "{1}" is set by the expression {2}: drive a value in that expression instead.</source>
   <translation>„{0}“ von „{1}“ wird durch den Ausdruck {2} gesetzt: Steuern Sie stattdessen einen Wert in diesem Ausdruck.</translation>
  </message>
  <message>
   <source>the clipboard has no rows of numbers: copy cells from a spreadsheet first.</source>
   <translation>Die Zwischenablage enthält keine Zeilen mit Zahlen: Kopieren Sie zuerst Zellen aus einer Tabelle.</translation>
  </message>
  <message>
   <source>there is already a key at this time: choose another time.</source>
   <translation>Zu dieser Zeit gibt es schon eine Stützstelle: Wählen Sie eine andere Zeit.</translation>
  </message>
  <message>
   <source>"{0}" is not a number or quantity in {1}: correct the entry.</source>
   <translation>„{0}“ ist keine Zahl oder Größe in {1}: Berichtigen Sie die Eingabe.</translation>
  </message>
  <message>
   <source>the time of key {0} must lie between the times of the keys before and after it.</source>
   <translation>Die Zeit der Stützstelle {0} muss zwischen den Zeiten der vorigen und der nächsten liegen.</translation>
  </message>
  <message>
   <source>row {0} of the pasted text has {1} columns: use t, x, y, z, or t, x, y, z, yaw, pitch, roll.</source>
   <translation>Zeile {0} des eingefügten Texts hat {1} Spalten: Verwenden Sie t, x, y, z oder t, x, y, z, Gier, Nick, Roll.</translation>
  </message>
  <message>
   <source>"{0}" stands still in all {1} frames: choose a part that is moved, or check the joints and formulas.</source>
   <translation>„{0}“ steht in allen {1} Bildern still: Wählen Sie ein Teil, das bewegt wird, oder prüfen Sie Gelenke und Formeln.</translation>
  </message>
  <message>
   <source>"{0}" gave no frames: check that it runs in its own panel.</source>
   <translation>„{0}“ ergab keine Bilder: Prüfen Sie, ob sie in ihrem eigenen Panel läuft.</translation>
  </message>
  <message>
   <source>choose at least one object with a placement.</source>
   <translation>Mindestens ein Objekt mit einer Platzierung wählen.</translation>
  </message>
  <message>
   <source>"{0}" has no placement, so it cannot be a pose: choose another object.</source>
   <translation>„{0}“ hat keine Platzierung und kann daher keine Lage sein: Wählen Sie ein anderes Objekt.</translation>
  </message>
  <message>
   <source>pose {0}: the time is {1:g}, but must be a finite number.</source>
   <translation>Lage {0}: Die Zeit ist {1:g}, muss aber eine endliche Zahl sein.</translation>
  </message>
  <message>
   <source>pose {0}: the time {1:g} s is earlier than the {2:g} s of the pose before; times must not decrease.</source>
   <translation>Lage {0}: Die Zeit {1:g} s liegt vor den {2:g} s der vorigen Lage; Zeiten dürfen nicht abnehmen.</translation>
  </message>
  <message>
   <source>the motion has no poses: add at least one.</source>
   <translation>Die Bewegung hat keine Lagen: mindestens eine hinzufügen.</translation>
  </message>
  <message>
   <source>the pose type "{0}" is unknown: use one of {1}.</source>
   <translation>Die Art der Lage „{0}“ ist unbekannt: Verwenden Sie eine von {1}.</translation>
  </message>
  <message>
   <source>the motion has {0} times but {1} placements: their numbers must be equal.</source>
   <translation>Die Bewegung hat {0} Zeiten, aber {1} Platzierungen: Ihre Anzahl muss gleich sein.</translation>
  </message>
  <message>
   <source>poses {0} and {1} have the same time ({2:g} s): a spline, or a motion with a reference part, needs different times.</source>
   <translation>Lagen {0} und {1} haben dieselbe Zeit ({2:g} s): Ein Spline oder eine Bewegung mit Bezugsteil braucht verschiedene Zeiten.</translation>
  </message>
  <message>
   <source>choose one Robot trajectory.</source>
   <translation>Eine Roboterbahn wählen.</translation>
  </message>
  <message>
   <source>"{0}" has {1} waypoints, but a motion needs at least two: add waypoints.</source>
   <translation>„{0}“ hat {1} Wegpunkte, aber eine Bewegung braucht mindestens zwei: Fügen Sie Wegpunkte hinzu.</translation>
  </message>
  <message>
   <source>the settings of the motion's source are damaged: create the motion again, or use its poses as they are.</source>
   <translation>Die Einstellungen der Quelle dieser Bewegung sind beschädigt: Legen Sie die Bewegung neu an, oder verwenden Sie ihre Lagen, wie sie sind.</translation>
  </message>
  <message>
   <source>this motion has no source to read again: its poses are stored in the document.</source>
   <translation>Diese Bewegung hat keine Quelle, die neu gelesen werden könnte: Ihre Lagen sind im Dokument gespeichert.</translation>
  </message>
  <message>
   <source>the number of poses is {0}, but must be {1} to {2}.</source>
   <translation>Die Anzahl der Lagen ist {0}, muss aber {1} bis {2} sein.</translation>
  </message>
  <message>
   <source>the spline from pose {0} to pose {1} is too extreme: check their times, placements and given velocities.</source>
   <translation>Der Spline von Lage {0} zu Lage {1} ist zu extrem: Prüfen Sie Zeiten, Platzierungen und gegebene Geschwindigkeiten.</translation>
  </message>
  <message>
   <source>"{0}" has no 3D view: open one in the menu Window.</source>
   <translation>„{0}“ hat keine 3D-Ansicht: im Menü Fenster eine öffnen.</translation>
  </message>
 </context>
 <context>
  <name>SweptVolume_Panels</name>
  <message>
   <source>{0} deep</source>
   <translation>{0} tief</translation>
  </message>
  <message>
   <source>the face itself, at a pose</source>
   <translation>die Fläche selbst, in einer Lage</translation>
  </message>
  <message>
   <source>swept by an edge</source>
   <translation>von einer Kante überstrichen</translation>
  </message>
  <message>
   <source>swept by a face that passed</source>
   <translation>von einer Fläche im Vorbeigehen überstrichen</translation>
  </message>
  <message>
   <source>{0}, at {1:.3f} s</source>
   <translation>{0}, bei {1:.3f} s</translation>
  </message>
  <message>
   <source>Face{0} of {1}</source>
   <translation>Face{0} von {1}</translation>
  </message>
  <message>
   <source>triangle {0} of {1}</source>
   <translation>Dreieck {0} von {1}</translation>
  </message>
  <message>
   <source>the edge between {0} and {1}</source>
   <translation>die Kante zwischen {0} und {1}</translation>
  </message>
  <message>
   <source>Result</source>
   <translation>Ergebnis</translation>
  </message>
  <message>
   <source>Verdict</source>
   <translation>Urteil</translation>
  </message>
  <message>
   <source>Measured between the meshes. The line above subtracts how far the meshes may deviate from the parts</source>
   <translation>Zwischen den Netzen gemessen. Die Zeile darüber zieht ab, wie weit die Netze von den Teilen abweichen dürfen</translation>
  </message>
  <message>
   <source>Colour the &amp;parts by their verdicts</source>
   <translation>&amp;Teile nach ihren Urteilen färben</translation>
  </message>
  <message>
   <source>CSV...</source>
   <translation>CSV …</translation>
  </message>
  <message>
   <source>Spreadsheet</source>
   <translation>Tabelle</translation>
  </message>
  <message>
   <source>Report...</source>
   <translation>Bericht ...</translation>
  </message>
  <message>
   <source>Time</source>
   <translation>Zeit</translation>
  </message>
  <message>
   <source>Depth</source>
   <translation>Tiefe</translation>
  </message>
  <message>
   <source>{0} (stale: run the check again)</source>
   <translation>{0} (veraltet: erneut prüfen)</translation>
  </message>
  <message>
   <source>Pre&amp;vious place</source>
   <translation>Vori&amp;ge Stelle</translation>
  </message>
  <message>
   <source>Goes back to the place that is worse than this one</source>
   <translation>Geht zurück zur Stelle, die schlimmer ist als diese</translation>
  </message>
  <message>
   <source>&amp;Next worst place</source>
   <translation>&amp;Nächstschlimmste Stelle</translation>
  </message>
  <message>
   <source>Goes through the places, the worst first: clashes by depth, then the others by distance</source>
   <translation>Geht die Stellen durch, die schlimmste zuerst: Kollisionen nach Tiefe, dann die anderen nach Abstand</translation>
  </message>
  <message>
   <source>Rule: {0}</source>
   <translation>Regel: {0}</translation>
  </message>
  <message>
   <source>No parts are in contact at the first pose.</source>
   <translation>In der ersten Lage sind keine Teile in Kontakt.</translation>
  </message>
  <message>
   <source>Contact is now allowed for these; check that it is intended: {0}</source>
   <translation>Kontakt ist nun erlaubt; prüfen Sie, ob er gewollt ist: {0}</translation>
  </message>
  <message>
   <source>{0}: {1} {2} at {3} s</source>
   <translation>{0}: {1} {2} bei {3} s</translation>
  </message>
  <message>
   <source>No graph yet: run the check first.</source>
   <translation>Noch kein Diagramm: Prüfen Sie zuerst.</translation>
  </message>
  <message>
   <source>distance ({0}) over time (s)</source>
   <translation>Abstand ({0}) über der Zeit (s)</translation>
  </message>
  <message>
   <source>Clearance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>(parts and motion below)</source>
   <translation>(Teile und Bewegung unten)</translation>
  </message>
  <message>
   <source>{0} neighbours: {1}</source>
   <translation>{0} Nachbarn: {1}</translation>
  </message>
  <message>
   <source>Check</source>
   <translation>Prüfen</translation>
  </message>
  <message>
   <source>Envelope</source>
   <translation>Hülle</translation>
  </message>
  <message>
   <source>Moving parts</source>
   <translation>Bewegte Teile</translation>
  </message>
  <message>
   <source>Motion</source>
   <translation>Bewegung</translation>
  </message>
  <message>
   <source>All visible</source>
   <translation>Alle sichtbaren</translation>
  </message>
  <message>
   <source>All other visible parts are neighbours</source>
   <translation>Alle anderen sichtbaren Teile sind Nachbarn</translation>
  </message>
  <message>
   <source>Ta&amp;ke selected as neighbours</source>
   <translation>Ausgewählte als &amp;Nachbarn</translation>
  </message>
  <message>
   <source>Required distance</source>
   <translation>Sollabstand</translation>
  </message>
  <message>
   <source>Accuracy</source>
   <translation>Genauigkeit</translation>
  </message>
  <message>
   <source>Mesh deflection</source>
   <translation>Netzabweichung</translation>
  </message>
  <message>
   <source>Distance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>Allows contact with the neighbours that the moving parts touch at the first pose</source>
   <translation>Erlaubt Kontakt mit den Nachbarn, die die bewegten Teile in der ersten Lage berühren</translation>
  </message>
  <message>
   <source>Allow initial con&amp;tacts</source>
   <translation>Anfangs&amp;kontakte erlauben</translation>
  </message>
  <message>
   <source>Neighbour</source>
   <translation>Nachbar</translation>
  </message>
  <message>
   <source>Makes a shared volume of the envelope and the part of the chosen row</source>
   <translation>Erzeugt ein gemeinsames Volumen aus der Hülle und dem Teil der gewählten Zeile</translation>
  </message>
  <message>
   <source>Colour the envelope by distance</source>
   <translation>Hülle nach Abstand einfärben</translation>
  </message>
  <message>
   <source>clash: inside</source>
   <translation>Kollision: innen</translation>
  </message>
  <message>
   <source>contact: up to</source>
   <translation>Kontakt: bis</translation>
  </message>
  <message>
   <source>below required: up to</source>
   <translation>unter Sollabstand: bis</translation>
  </message>
  <message>
   <source>clear: beyond</source>
   <translation>frei: darüber</translation>
  </message>
  <message>
   <source>The envelope has changed since the check: run the check again.</source>
   <translation>Die Hülle hat sich seit der Prüfung geändert: Prüfen Sie erneut.</translation>
  </message>
  <message>
   <source>Keep volume to cut awa&amp;y</source>
   <translation>Abzutragendes Volumen behal&amp;ten</translation>
  </message>
  <message>
   <source>Swept envelope</source>
   <translation>Bewegungshülle</translation>
  </message>
  <message>
   <source>Cells along the longest side of the swept volume</source>
   <translation>Zellen entlang der längsten Seite des überstrichenen Volumens</translation>
  </message>
  <message>
   <source>; about {0}, {1}</source>
   <translation>; etwa {0}, {1}</translation>
  </message>
  <message>
   <source>{0} x {1} x {2} cells of {3}</source>
   <translation>{0} x {1} x {2} Zellen zu {3}</translation>
  </message>
  <message>
   <source>Coarse and fast on the left, fine and slow on the right</source>
   <translation>Links grob und schnell, rechts fein und langsam</translation>
  </message>
  <message>
   <source>How far simplification may move the surface; 0: no simplification</source>
   <translation>Wie weit Vereinfachung die Oberfläche verschieben darf; 0: keine Vereinfachung</translation>
  </message>
  <message>
   <source>Grows the envelope by this distance on all sides</source>
   <translation>Vergrößert die Hülle auf allen Seiten um diesen Abstand</translation>
  </message>
  <message>
   <source>Set cell size by</source>
   <translation>Zellgröße vorgeben durch</translation>
  </message>
  <message>
   <source>Resolution</source>
   <translation>Auflösung</translation>
  </message>
  <message>
   <source>Quality</source>
   <translation>Güte</translation>
  </message>
  <message>
   <source>Cell size</source>
   <translation>Zellgröße</translation>
  </message>
  <message>
   <source>Tolerance</source>
   <translation>Toleranz</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Versatz</translation>
  </message>
  <message>
   <source>Conservative</source>
   <translation>Konservativ</translation>
  </message>
  <message>
   <source>Grows the envelope until it provably contains the swept volume</source>
   <translation>Vergrößert die Hülle, bis sie das überstrichene Volumen nachweislich enthält</translation>
  </message>
  <message>
   <source>Keep cavities</source>
   <translation>Hohlräume behalten</translation>
  </message>
  <message>
   <source>Keeps enclosed cavities as inner shells</source>
   <translation>Erhält eingeschlossene Hohlräume als innere Schalen</translation>
  </message>
  <message>
   <source>Show a coarse envelope</source>
   <translation>Grobe Hülle zeigen</translation>
  </message>
  <message>
   <source>Method</source>
   <translation>Verfahren</translation>
  </message>
  <message>
   <source>For recordings of very many poses: skips a pose if no point of the part has moved farther than this since the last pose used; 0: uses all</source>
   <translation>Für Aufzeichnungen mit sehr vielen Lagen: überspringt eine Lage, wenn sich seit der letzten verwendeten kein Punkt des Teils weiter als dies bewegt hat; 0: verwendet alle</translation>
  </message>
  <message>
   <source>Components</source>
   <translation>Flächenstücke</translation>
  </message>
  <message>
   <source>Backend</source>
   <translation>Rechenwerk</translation>
  </message>
  <message>
   <source>Position filter</source>
   <translation>Lagenfilter</translation>
  </message>
  <message>
   <source>Records which face or edge of which part made each triangle, and when, for "What made this?". Stored in the document, it makes the file larger</source>
   <translation>Merkt sich für „Was hat das erzeugt?“, welche Fläche oder Kante welches Teils jedes Dreieck erzeugt hat und wann. Im Dokument gespeichert, vergrößert es die Datei</translation>
  </message>
  <message>
   <source>Made by</source>
   <translation>Erzeugt von</translation>
  </message>
  <message>
   <source>Reading the parts ...</source>
   <translation>Die Teile werden gelesen ...</translation>
  </message>
  <message>
   <source>Most poses are nearly equal: a position filter of {0} skips them and is much faster.</source>
   <translation>Die meisten Lagen sind fast gleich: Ein Lagenfilter von {0} überspringt sie und ist viel schneller.</translation>
  </message>
  <message>
   <source>The motion has only one key, so the parts do not move: add another key.</source>
   <translation>Die Bewegung hat nur eine Stützstelle, die Teile bewegen sich also nicht: Fügen Sie eine weitere hinzu.</translation>
  </message>
  <message>
   <source>Export envelope</source>
   <translation>Hülle exportieren</translation>
  </message>
  <message>
   <source>Export report</source>
   <translation>Bericht exportieren</translation>
  </message>
  <message>
   <source>Export table</source>
   <translation>Tabelle exportieren</translation>
  </message>
  <message>
   <source>Study file</source>
   <translation>Studiendatei</translation>
  </message>
  <message>
   <source>Folder for results</source>
   <translation>Ordner für Ergebnisse</translation>
  </message>
  <message>
   <source>{0} poses, {1} to {2} s, travel {3} x {4} x {5}</source>
   <translation>{0} Lagen, {1} bis {2} s, Verfahrweg {3} x {4} x {5}</translation>
  </message>
  <message>
   <source>Motions</source>
   <translation>Bewegungen</translation>
  </message>
  <message>
   <source>All files</source>
   <translation>Alle Dateien</translation>
  </message>
  <message>
   <source>Motion from file</source>
   <translation>Bewegung aus Datei</translation>
  </message>
  <message>
   <source>File</source>
   <translation>Datei</translation>
  </message>
  <message>
   <source>Unit</source>
   <translation>Einheit</translation>
  </message>
  <message>
   <source>Interpolation</source>
   <translation>Interpolation</translation>
  </message>
  <message>
   <source>Pose type</source>
   <translation>Art der Lage</translation>
  </message>
  <message>
   <source>&amp;Find path</source>
   <translation>Bahn &amp;finden</translation>
  </message>
  <message>
   <source>Find path</source>
   <translation>Bahn finden</translation>
  </message>
  <message>
   <source>Start and goal</source>
   <translation>Start und Ziel</translation>
  </message>
  <message>
   <source>&amp;Pick</source>
   <translation>Wählen</translation>
  </message>
  <message>
   <source>Takes the part that is selected in the tree or in the view</source>
   <translation>Übernimmt das Teil, das im Baum oder in der Ansicht gewählt ist</translation>
  </message>
  <message>
   <source>Part</source>
   <translation>Teil</translation>
  </message>
  <message>
   <source>Goal</source>
   <translation>Ziel</translation>
  </message>
  <message>
   <source>Start</source>
   <translation>Start</translation>
  </message>
  <message>
   <source>The part never turns</source>
   <translation>Das Teil dreht sich nie</translation>
  </message>
  <message>
   <source>Largest rotation away from the orientation at the goal; 180: no limit</source>
   <translation>Größte Drehung gegenüber der Ausrichtung am Ziel; 180: keine Grenze</translation>
  </message>
  <message>
   <source>Largest turn</source>
   <translation>Größte Drehung</translation>
  </message>
  <message>
   <source>Running "{0}" ...</source>
   <translation>„{0}“ läuft ...</translation>
  </message>
  <message>
   <source>&amp;Improve path</source>
   <translation>Bahn ver&amp;bessern</translation>
  </message>
  <message>
   <source>Improve path</source>
   <translation>Bahn verbessern</translation>
  </message>
  <message>
   <source>Key {0}, {1} s</source>
   <translation>Stützstelle {0}, {1} s</translation>
  </message>
  <message>
   <source>Ticked keys keep their placement and time</source>
   <translation>Angehakte Stützstellen behalten Platzierung und Zeit</translation>
  </message>
  <message>
   <source>Locked</source>
   <translation>Gesperrt</translation>
  </message>
  <message>
   <source>Increases the clearance, even if the path gets longer; otherwise the path is as short as the required distance allows</source>
   <translation>Vergrößert den Abstand, auch wenn die Bahn länger wird; sonst ist die Bahn so kurz, wie der Sollabstand erlaubt</translation>
  </message>
  <message>
   <source>Maximise clearance</source>
   <translation>Abstand maximieren</translation>
  </message>
  <message>
   <source>The last change of the keys</source>
   <translation>Die letzte Änderung der Stützstellen</translation>
  </message>
  <message>
   <source>yaw</source>
   <translation>Gier</translation>
  </message>
  <message>
   <source>pitch</source>
   <translation>Nick</translation>
  </message>
  <message>
   <source>roll</source>
   <translation>Roll</translation>
  </message>
  <message>
   <source>Key placements</source>
   <translation>Stützstellen</translation>
  </message>
  <message>
   <source>&amp;Capture</source>
   <translation>Aufn&amp;ehmen</translation>
  </message>
  <message>
   <source>Adds the current placement of the part as a key (Ctrl+Return)</source>
   <translation>Fügt die jetzige Platzierung des Teils als Stützstelle an (Strg+Eingabe)</translation>
  </message>
  <message>
   <source>&amp;Update</source>
   <translation>Über&amp;nehmen</translation>
  </message>
  <message>
   <source>Replaces the placement of this key by the current placement of the part</source>
   <translation>Ersetzt die Platzierung dieser Stützstelle durch die jetzige des Teils</translation>
  </message>
  <message>
   <source>&amp;Insert</source>
   <translation>E&amp;infügen</translation>
  </message>
  <message>
   <source>Adds a key halfway to the next one (Insert)</source>
   <translation>Fügt eine Stützstelle auf halbem Weg zur nächsten ein (Einfg)</translation>
  </message>
  <message>
   <source>&amp;Duplicate</source>
   <translation>&amp;Verdoppeln</translation>
  </message>
  <message>
   <source>Adds the same placement again (Ctrl+D)</source>
   <translation>Fügt dieselbe Platzierung noch einmal an (Strg+D)</translation>
  </message>
  <message>
   <source>De&amp;lete</source>
   <translation>&amp;Löschen</translation>
  </message>
  <message>
   <source>Removes the key (Delete)</source>
   <translation>Entfernt die Stützstelle (Entf)</translation>
  </message>
  <message>
   <source>&amp;Reverse</source>
   <translation>&amp;Umkehren</translation>
  </message>
  <message>
   <source>Reverses the order of the keys</source>
   <translation>Kehrt die Reihenfolge der Stützstellen um</translation>
  </message>
  <message>
   <source>Up</source>
   <translation>Nach oben</translation>
  </message>
  <message>
   <source>Moves the key one place earlier (Ctrl+Up)</source>
   <translation>Rückt die Stützstelle um einen Platz nach vorn (Strg+Auf)</translation>
  </message>
  <message>
   <source>Down</source>
   <translation>Nach unten</translation>
  </message>
  <message>
   <source>Moves the key one place later (Ctrl+Down)</source>
   <translation>Rückt die Stützstelle um einen Platz nach hinten (Strg+Ab)</translation>
  </message>
  <message>
   <source>Eve&amp;n times</source>
   <translation>&amp;Gleiche Zeiten</translation>
  </message>
  <message>
   <source>Sets the times one second apart</source>
   <translation>Setzt die Zeiten im Abstand von einer Sekunde</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Quelle</translation>
  </message>
  <message>
   <source>{0} to {1}</source>
   <translation>{0} bis {1}</translation>
  </message>
  <message>
   <source>Show the clearance while dragging</source>
   <translation>Abstand beim Ziehen zeigen</translation>
  </message>
  <message>
   <source>Stops the dragged key where the part would touch a neighbour; all visible parts are neighbours</source>
   <translation>Hält die gezogene Stützstelle an, wo das Teil einen Nachbarn berühren würde; alle sichtbaren Teile sind Nachbarn</translation>
  </message>
  <message>
   <source>Clash with {1}</source>
   <translation>Kollision mit {1}</translation>
  </message>
  <message>
   <source>Stop at contact</source>
   <translation>Bei Kontakt anhalten</translation>
  </message>
  <message>
   <source>Contact with {1} ({0})</source>
   <translation>Kontakt mit {1} ({0})</translation>
  </message>
  <message>
   <source>The envelope is stale: this information is about the parts and the motion from which it was computed. Recompute it to see them move.</source>
   <translation>Die Hülle ist veraltet: Diese Angaben gelten für die Teile und die Bewegung, aus denen sie berechnet wurde. Berechnen Sie sie neu, um die Bewegung zu sehen.</translation>
  </message>
  <message>
   <source>What made this?</source>
   <translation>Was hat das erzeugt?</translation>
  </message>
  <message>
   <source>Compute and record</source>
   <translation>Berechnen und aufzeichnen</translation>
  </message>
  <message>
   <source>Colour by</source>
   <translation>Färben nach</translation>
  </message>
  <message>
   <source>Clicked place</source>
   <translation>Angeklickte Stelle</translation>
  </message>
  <message>
   <source>Select on the part</source>
   <translation>Am Teil auswählen</translation>
  </message>
  <message>
   <source>Click a place of the envelope in the 3D view.</source>
   <translation>Klicken Sie in der 3D-Ansicht auf eine Stelle der Hülle.</translation>
  </message>
  <message>
   <source>What made this envelope was not recorded, or the record was lost when the document was closed: press Compute and record.</source>
   <translation>Was diese Hülle erzeugt hat, wurde nicht aufgezeichnet oder ging beim Schließen des Dokuments verloren: Drücken Sie „Berechnen und aufzeichnen“.</translation>
  </message>
  <message>
   <source>For this place it is not known what made it: click beside it.</source>
   <translation>Für diese Stelle ist nicht bekannt, was sie erzeugt hat: Klicken Sie daneben.</translation>
  </message>
  <message>
   <source>Mechanism</source>
   <translation>Mechanismus</translation>
  </message>
  <message>
   <source>Pairs of parts that come nearer than this are listed; 0: a tenth of the size of the parts, or more if a rule needs it</source>
   <translation>Paare von Teilen, die sich näher kommen, werden aufgeführt; 0: ein Zehntel der Größe der Teile, oder mehr, wenn eine Regel es braucht</translation>
  </message>
  <message>
   <source>{0} parts that stand still: {1}</source>
   <translation>{0} stillstehende Teile: {1}</translation>
  </message>
  <message>
   <source>All other visible parts are neighbours that stand still</source>
   <translation>Alle anderen sichtbaren Teile sind stillstehende Nachbarn</translation>
  </message>
  <message>
   <source>Allows contact between parts that touch at the start, for example at their joints</source>
   <translation>Erlaubt Kontakt zwischen Teilen, die sich am Anfang berühren, etwa an ihren Gelenken</translation>
  </message>
  <message>
   <source>Pair</source>
   <translation>Paar</translation>
  </message>
  <message>
   <source>Range</source>
   <translation>Bereich</translation>
  </message>
  <message>
   <source>none: select the part, then press Pick</source>
   <translation>keines: Wählen Sie das Teil, und drücken Sie „Wählen“</translation>
  </message>
  <message>
   <source>Step size of the arrows and arcs; 0: no steps</source>
   <translation>Schrittweite der Pfeile und Bögen; 0: keine Schritte</translation>
  </message>
  <message>
   <source>A motion needs at least two keys: move the part, then press Capture.</source>
   <translation>Eine Bewegung braucht mindestens zwei Stützstellen: Bewegen Sie das Teil, und drücken Sie „Aufnehmen“.</translation>
  </message>
  <message>
   <source>Pivot</source>
   <translation>Drehpunkt</translation>
  </message>
  <message>
   <source>In the 3D view</source>
   <translation>In der 3D-Ansicht</translation>
  </message>
  <message>
   <source>Drag the chosen key</source>
   <translation>Gewählte Stützstelle ziehen</translation>
  </message>
  <message>
   <source>R&amp;ound</source>
   <translation>&amp;Runden</translation>
  </message>
  <message>
   <source>Rounds the placement of the chosen key to these steps</source>
   <translation>Rundet die Platzierung der gewählten Stützstelle auf diese Schritte</translation>
  </message>
  <message>
   <source>Snap</source>
   <translation>Raster</translation>
  </message>
  <message>
   <source>&amp;Add selected</source>
   <translation>Auswahl hin&amp;zufügen</translation>
  </message>
  <message>
   <source>Adds the parts selected in the tree, and the parts of selected motions</source>
   <translation>Fügt die im Baum gewählten Teile hinzu und die Teile gewählter Bewegungen</translation>
  </message>
  <message>
   <source>&amp;Remove</source>
   <translation>En&amp;tfernen</translation>
  </message>
  <message>
   <source>Removes the marked parts from the list</source>
   <translation>Entfernt die markierten Teile aus der Liste</translation>
  </message>
  <message>
   <source>Add a&amp;ll its parts</source>
   <translation>A&amp;lle ihre Teile hinzufügen</translation>
  </message>
  <message>
   <source>Runs the source once and adds every part that moves. Existing motions of these parts are read again, others are created</source>
   <translation>Lässt die Quelle einmal laufen und fügt jedes Teil hinzu, das sich bewegt. Vorhandene Bewegungen dieser Teile werden neu gelesen, andere angelegt</translation>
  </message>
  <message>
   <source>(choose)</source>
   <translation>(wählen)</translation>
  </message>
  <message>
   <source>Neighbours</source>
   <translation>Nachbarn</translation>
  </message>
  <message>
   <source>Adds the solids and meshes selected in the tree</source>
   <translation>Fügt die im Baum ausgewählten Festkörper und Netze hinzu</translation>
  </message>
  <message>
   <source>All &amp;visible</source>
   <translation>Alle si&amp;chtbaren</translation>
  </message>
  <message>
   <source>All other parts that are visible now</source>
   <translation>Alle anderen Teile, die jetzt sichtbar sind</translation>
  </message>
  <message>
   <source>Reserved spaces</source>
   <translation>Reservierte Räume</translation>
  </message>
  <message>
   <source>{0} chosen: {1}</source>
   <translation>{0} gewählt: {1}</translation>
  </message>
  <message>
   <source>Pairs checked: {0}, none shares volume, smallest distance: {1}</source>
   <translation>Geprüfte Paare: {0}, keines mit gemeinsamem Volumen, kleinster Abstand: {1}</translation>
  </message>
  <message>
   <source>Ta&amp;ke selected</source>
   <translation>Ausge&amp;wählte nehmen</translation>
  </message>
  <message>
   <source>Adds the volume that both share as an object, which shows when it is out of date</source>
   <translation>Fügt das gemeinsame Volumen als Objekt hinzu, das zeigt, wenn es veraltet ist</translation>
  </message>
  <message>
   <source>Pairs checked: {0}, shared volume: {1}</source>
   <translation>Geprüfte Paare: {0}, gemeinsames Volumen: {1}</translation>
  </message>
  <message>
   <source>not known</source>
   <translation>unbekannt</translation>
  </message>
  <message>
   <source>shared</source>
   <translation>gemeinsam</translation>
  </message>
  <message>
   <source>Keep s&amp;hared volume</source>
   <translation>&amp;Gemeinsames Volumen behalten</translation>
  </message>
  <message>
   <source>Take selected</source>
   <translation>Auswahl nehmen</translation>
  </message>
  <message>
   <source>Relative to a moving part</source>
   <translation>Relativ zu einem bewegten Teil</translation>
  </message>
  <message>
   <source>Computes the space that the moving parts occupy as seen from this part</source>
   <translation>Berechnet den Raum, den die bewegten Teile von diesem Teil aus gesehen einnehmen</translation>
  </message>
  <message>
   <source>Takes the part that is selected in the tree</source>
   <translation>Nimmt das im Baum gewählte Teil</translation>
  </message>
  <message>
   <source>as below</source>
   <translation>wie unten</translation>
  </message>
  <message>
   <source>Own motion</source>
   <translation>Eigene Bewegung</translation>
  </message>
  <message>
   <source>Reference</source>
   <translation>Bezugsteil</translation>
  </message>
  <message>
   <source>Reference motion</source>
   <translation>Bezugsbewegung</translation>
  </message>
  <message>
   <source>Paths</source>
   <translation>Bahnen</translation>
  </message>
  <message>
   <source>Keys</source>
   <translation>Stützstellen</translation>
  </message>
  <message>
   <source>Turns</source>
   <translation>Drehung</translation>
  </message>
  <message>
   <source>The point that moves straight between two keys and about which the part turns. The x, y, z of a key are the coordinates of this point.</source>
   <translation>Der Punkt, der sich zwischen zwei Stützstellen gerade bewegt und um den sich das Teil dreht. x, y, z einer Stützstelle sind die Koordinaten dieses Punkts.</translation>
  </message>
  <message>
   <source>Middle of the part</source>
   <translation>Mitte des Teils</translation>
  </message>
  <message>
   <source>Origin of the poses</source>
   <translation>Ursprung der Lagen</translation>
  </message>
  <message>
   <source>Selected point</source>
   <translation>Gewählter Punkt</translation>
  </message>
  <message>
   <source>Ta&amp;ke</source>
   <translation>Set&amp;zen</translation>
  </message>
  <message>
   <source>Takes the selected vertex, or the centre of the selected edge or face</source>
   <translation>Übernimmt den gewählten Punkt oder die Mitte der gewählten Kante oder Fläche</translation>
  </message>
  <message>
   <source>In the coordinates of the part: {0}, {1}, {2}</source>
   <translation>In den Koordinaten des Teils: {0}, {1}, {2}</translation>
  </message>
  <message>
   <source>Current placement</source>
   <translation>Jetzige Platzierung</translation>
  </message>
  <message>
   <source>Given placement</source>
   <translation>Gegebene Platzierung</translation>
  </message>
  <message>
   <source>Out by a distance</source>
   <translation>Um einen Abstand hinaus</translation>
  </message>
  <message>
   <source>Out in a direction</source>
   <translation>In einer Richtung hinaus</translation>
  </message>
  <message>
   <source>Take</source>
   <translation>Nehmen</translation>
  </message>
  <message>
   <source>Direction x, y, z in which the part leaves. Take uses the normal of the selected face, or the direction of the selected edge</source>
   <translation>Richtung x, y, z, in der das Teil hinausgeht. „Nehmen“ verwendet die Normale der gewählten Fläche oder die Richtung der gewählten Kante</translation>
  </message>
  <message>
   <source>x, y, z ({0}), yaw, pitch, roll (degrees) of the part in the document. Take uses the placement of the selected object, or of the part if nothing is selected</source>
   <translation>x, y, z ({0}), Gier, Nick, Roll (Grad) des Teils im Dokument. „Nehmen“ verwendet die Platzierung des gewählten Objekts, ohne Auswahl die des Teils</translation>
  </message>
  <message>
   <source>Hides everything in front of the closest place; follows the chosen row and the player</source>
   <translation>Blendet alles vor der nächsten Stelle aus; folgt der gewählten Zeile und dem Abspielen</translation>
  </message>
  <message>
   <source>Makes a shared volume of the two parts of the chosen row, at its time</source>
   <translation>Erzeugt ein gemeinsames Volumen aus den zwei Teilen der gewählten Zeile zu deren Zeit</translation>
  </message>
  <message>
   <source>clash</source>
   <translation>Kollision</translation>
  </message>
  <message>
   <source>S&amp;ection through the closest place</source>
   <translation>&amp;Schnitt durch die nächste Stelle</translation>
  </message>
  <message>
   <source>Keep clas&amp;h volume</source>
   <translation>Kollisions&amp;volumen behalten</translation>
  </message>
  <message>
   <source>Play</source>
   <translation>Abspielen</translation>
  </message>
  <message>
   <source>Time: the green ghost shows the part there</source>
   <translation>Zeit: der grüne Schatten zeigt dort das Teil</translation>
  </message>
  <message>
   <source>To the previous key</source>
   <translation>Zur vorigen Stützstelle</translation>
  </message>
  <message>
   <source>Pl&amp;ay</source>
   <translation>Ab&amp;spielen</translation>
  </message>
  <message>
   <source>Plays in real time at speed 1, or pauses</source>
   <translation>Spielt bei Tempo 1 in Echtzeit ab oder hält an</translation>
  </message>
  <message>
   <source>To the next key</source>
   <translation>Zur nächsten Stützstelle</translation>
  </message>
  <message>
   <source>Speed: seconds of the motion per second</source>
   <translation>Tempo: Sekunden der Bewegung je Sekunde</translation>
  </message>
  <message>
   <source>Loop</source>
   <translation>Schleife</translation>
  </message>
  <message>
   <source>Starts again at the end</source>
   <translation>Beginnt am Ende von vorn</translation>
  </message>
  <message>
   <source>P&amp;ause</source>
   <translation>Pau&amp;se</translation>
  </message>
  <message>
   <source>Volume: {0}</source>
   <translation>Volumen: {0}</translation>
  </message>
  <message>
   <source>Box: {0}</source>
   <translation>Hüllquader: {0}</translation>
  </message>
  <message>
   <source>Triangles: {0}, shells: {1}</source>
   <translation>Dreiecke: {0}, Schalen: {1}</translation>
  </message>
  <message>
   <source>Cell: {0}, simplified by: {1}</source>
   <translation>Zelle: {0}, vereinfacht um: {1}</translation>
  </message>
  <message>
   <source>Time: {0} on {1}</source>
   <translation>Zeit: {0} auf {1}</translation>
  </message>
  <message>
   <source>Last run: {0}</source>
   <translation>Letzter Lauf: {0}</translation>
  </message>
  <message>
   <source>Warnings: {0}</source>
   <translation>Warnungen: {0}</translation>
  </message>
  <message>
   <source>Contact allowed</source>
   <translation>Kontakt erlaubt</translation>
  </message>
  <message>
   <source>Ignored</source>
   <translation>Übergangen</translation>
  </message>
  <message>
   <source>Double-click a cell, or press F2, to choose another rule</source>
   <translation>Doppelklick auf eine Zelle oder F2, um eine andere Regel zu wählen</translation>
  </message>
  <message>
   <source>Rule</source>
   <translation>Regel</translation>
  </message>
  <message>
   <source>The required distance for this row; empty: the common required distance below. If contact is allowed: how deep the parts may overlap; empty: no measurable overlap</source>
   <translation>Der Sollabstand für diese Zeile; leer: der gemeinsame Sollabstand unten. Wenn Kontakt erlaubt ist: wie tief sich die Teile durchdringen dürfen; leer: nicht messbar</translation>
  </message>
  <message>
   <source>The required distance for this row; empty: the common required distance below</source>
   <translation>Der Sollabstand für diese Zeile; leer: der gemeinsame Sollabstand unten</translation>
  </message>
  <message>
   <source>Rules</source>
   <translation>Regeln</translation>
  </message>
  <message>
   <source>A neighbour that is nearer than the required distance at the start or the end may stay so until a point of the part has moved this far from there</source>
   <translation>Ein Nachbar, der am Start oder am Ziel näher ist als der Sollabstand, darf es bleiben, bis sich ein Punkt des Teils so weit von dort entfernt hat</translation>
  </message>
  <message>
   <source>Release distance</source>
   <translation>Freigabeabstand</translation>
  </message>
  <message>
   <source>The search uses random numbers; another seed may find another path</source>
   <translation>Die Suche verwendet Zufallszahlen; eine andere Startzahl findet vielleicht eine andere Bahn</translation>
  </message>
  <message>
   <source>Time limit</source>
   <translation>Zeitgrenze</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>Startzahl</translation>
  </message>
  <message>
   <source>&amp;Find paths in this order</source>
   <translation>Bahnen in dieser Reihenfolge &amp;finden</translation>
  </message>
  <message>
   <source>Sequence</source>
   <translation>Einbaufolge</translation>
  </message>
  <message>
   <source>searching ({0} of {1} found)</source>
   <translation>wird gesucht ({0} von {1} gefunden)</translation>
  </message>
  <message>
   <source>Find an &amp;order</source>
   <translation>&amp;Reihenfolge finden</translation>
  </message>
  <message>
   <source>Finds an order of disassembly and reverses it</source>
   <translation>Findet eine Reihenfolge der Demontage und kehrt sie um</translation>
  </message>
  <message>
   <source>Distance from its goal at which a part counts as removed</source>
   <translation>Abstand vom Ziel, bei dem ein Teil als ausgebaut gilt</translation>
  </message>
  <message>
   <source>The parts never turn</source>
   <translation>Die Teile drehen sich nie</translation>
  </message>
  <message>
   <source>Removal distance</source>
   <translation>Ausbauabstand</translation>
  </message>
  <message>
   <source>{0} (stale: check again)</source>
   <translation>{0} (veraltet: neu prüfen)</translation>
  </message>
  <message>
   <source>Moving parts, in order of installation</source>
   <translation>Bewegte Teile, in der Reihenfolge des Einbaus</translation>
  </message>
  <message>
   <source>State</source>
   <translation>Zustand</translation>
  </message>
  <message>
   <source>A&amp;dd selected</source>
   <translation>Gewählte hin&amp;zufügen</translation>
  </message>
  <message>
   <source>Adds the parts selected in the tree or in the view</source>
   <translation>Fügt die im Baum oder in der Ansicht gewählten Teile hinzu</translation>
  </message>
  <message>
   <source>Re&amp;move</source>
   <translation>&amp;Entfernen</translation>
  </message>
  <message>
   <source>Removes the marked part from the sequence</source>
   <translation>Entfernt das markierte Teil aus der Einbaufolge</translation>
  </message>
  <message>
   <source>&amp;Up</source>
   <translation>&amp;Auf</translation>
  </message>
  <message>
   <source>Moves the marked part one step earlier</source>
   <translation>Rückt das markierte Teil um einen Schritt nach vorn</translation>
  </message>
  <message>
   <source>D&amp;own</source>
   <translation>A&amp;b</translation>
  </message>
  <message>
   <source>Moves the marked part one step later</source>
   <translation>Rückt das markierte Teil um einen Schritt nach hinten</translation>
  </message>
  <message>
   <source>find a path</source>
   <translation>Bahn finden</translation>
  </message>
  <message>
   <source>Solid</source>
   <translation>Festkörper</translation>
  </message>
  <message>
   <source>Merge coplanar</source>
   <translation>Koplanare vereinigen</translation>
  </message>
  <message>
   <source>Merges coplanar triangles into single flat faces</source>
   <translation>Vereinigt koplanare Dreiecke zu einzelnen ebenen Flächen</translation>
  </message>
  <message>
   <source>How far the solid may deviate from the mesh; 0: exact, unless Max faces forces a tolerance</source>
   <translation>Wie weit der Festkörper vom Netz abweichen darf; 0: genau, sofern „Max. Flächen“ keine Toleranz erzwingt</translation>
  </message>
  <message>
   <source>If the tolerance is 0, the smallest tolerance that stays within this limit is chosen</source>
   <translation>Ist die Toleranz 0, wird die kleinste gewählt, die diese Grenze einhält</translation>
  </message>
  <message>
   <source>no limit</source>
   <translation>keine Grenze</translation>
  </message>
  <message>
   <source>Tessellated (AP242)</source>
   <translation>Tesselliert (AP242)</translation>
  </message>
  <message>
   <source>Writes the triangles themselves instead of faces: exact, fast and of any size. Only programs that read tessellated STEP can open it; FreeCAD 0.20 cannot</source>
   <translation>Schreibt die Dreiecke selbst statt Flächen: genau, schnell und beliebig groß. Nur Programme, die tesselliertes STEP lesen, können die Datei öffnen; FreeCAD 0.20 nicht</translation>
  </message>
  <message>
   <source>Max faces</source>
   <translation>Max. Flächen</translation>
  </message>
  <message>
   <source>Estimating the solid ...</source>
   <translation>Der Festkörper wird abgeschätzt ...</translation>
  </message>
  <message>
   <source>{0} triangles: {1} faces,
about {2}, {3}</source>
   <translation>{0} Dreiecke: {1} Flächen,
etwa {2}, {3}</translation>
  </message>
  <message>
   <source>{0} triangles: at most {1} faces,
up to about {2}, {3}</source>
   <translation>{0} Dreiecke: höchstens {1} Flächen,
bis etwa {2}, {3}</translation>
  </message>
  <message>
   <source>Make solid</source>
   <translation>Festkörper erzeugen</translation>
  </message>
  <message>
   <source>Max file size</source>
   <translation>Max. Dateigröße</translation>
  </message>
  <message>
   <source>The limits need a tolerance of {0}</source>
   <translation>Die Grenzen erfordern eine Toleranz von {0}</translation>
  </message>
  <message>
   <source>Motion from object</source>
   <translation>Bewegung aus Objekt</translation>
  </message>
  <message>
   <source>Motion from driven value</source>
   <translation>Bewegung aus gesteuertem Wert</translation>
  </message>
  <message>
   <source>No part is selected: every part that moves gets a motion.</source>
   <translation>Kein Teil ist ausgewählt: Jedes Teil, das sich bewegt, erhält eine Bewegung.</translation>
  </message>
  <message>
   <source>How far the straight line between two poses may deviate from the curve; corners always get a pose</source>
   <translation>Wie weit die Gerade zwischen zwei Lagen von der Kurve abweichen darf; Ecken erhalten immer eine Lage</translation>
  </message>
  <message>
   <source>Fixed</source>
   <translation>Fest</translation>
  </message>
  <message>
   <source>Tangent</source>
   <translation>Tangente</translation>
  </message>
  <message>
   <source>Second curve</source>
   <translation>Zweite Kurve</translation>
  </message>
  <message>
   <source>Fixed: the part never turns. Tangent: the x axis of the part follows the tangent. Second curve: the z axis points to the second curve; select both curves, the one to follow first</source>
   <translation>Fest: Das Teil dreht sich nie. Tangente: Die x-Achse des Teils folgt der Tangente. Zweite Kurve: Die z-Achse zeigt zur zweiten Kurve; beide Kurven auswählen, die Leitkurve zuerst</translation>
  </message>
  <message>
   <source>Orientation</source>
   <translation>Ausrichtung</translation>
  </message>
  <message>
   <source>Duration</source>
   <translation>Dauer</translation>
  </message>
  <message>
   <source>Step</source>
   <translation>Schritt</translation>
  </message>
  <message>
   <source>Tool head</source>
   <translation>Werkzeugkopf</translation>
  </message>
  <message>
   <source>Table</source>
   <translation>Tisch</translation>
  </message>
  <message>
   <source>What A, B and C rotate, in degrees about the fixed axes x, then y, then z. Tool head: X Y Z are coordinates of the workpiece. Table: X Y Z are coordinates of the machine, and the table turns the workpiece</source>
   <translation>Was A, B und C drehen, in Grad um die festen Achsen x, dann y, dann z. Werkzeugkopf: X Y Z sind Koordinaten des Werkstücks. Tisch: X Y Z sind Koordinaten der Maschine, und der Tisch dreht das Werkstück</translation>
  </message>
  <message>
   <source>Rotary axes</source>
   <translation>Drehachsen</translation>
  </message>
  <message>
   <source>Rapid</source>
   <translation>Eilgang</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Wert</translation>
  </message>
  <message>
   <source>Count</source>
   <translation>Anzahl</translation>
  </message>
  <message>
   <source>Press OK again to use the motion as it is.</source>
   <translation>Noch einmal OK übernimmt die Bewegung, wie sie ist.</translation>
  </message>
  <message>
   <source>End</source>
   <translation>Ende</translation>
  </message>
  <message>
   <source>The poses of "{0}" are linked to {1}. To edit a key, the link must be removed; the motion then keeps its current poses. Remove the link?</source>
   <translation>Die Lagen von „{0}“ sind mit {1} verknüpft. Um eine Stützstelle zu bearbeiten, muss die Verknüpfung entfernt werden; die Bewegung behält dann ihre jetzigen Lagen. Verknüpfung entfernen?</translation>
  </message>
  <message>
   <source>Study</source>
   <translation>Studie</translation>
  </message>
  <message>
   <source>Results</source>
   <translation>Ergebnisse</translation>
  </message>
  <message>
   <source>Runs</source>
   <translation>Läufe</translation>
  </message>
  <message>
   <source>beside the file</source>
   <translation>neben der Datei</translation>
  </message>
  <message>
   <source>one for each core</source>
   <translation>einer je Kern</translation>
  </message>
  <message>
   <source>Runs at once</source>
   <translation>Läufe gleichzeitig</translation>
  </message>
  <message>
   <source>Opens the page of all runs in the web browser</source>
   <translation>Öffnet die Seite aller Läufe im Webbrowser</translation>
  </message>
  <message>
   <source>Continue</source>
   <translation>Fortfahren</translation>
  </message>
  <message>
   <source>Run study</source>
   <translation>Studie rechnen</translation>
  </message>
  <message>
   <source>of this document</source>
   <translation>dieses Dokuments</translation>
  </message>
  <message>
   <source>of a study file</source>
   <translation>einer Studiendatei</translation>
  </message>
  <message>
   <source>&amp;Open worst</source>
   <translation>&amp;Schlimmsten öffnen</translation>
  </message>
  <message>
   <source>&amp;Open run</source>
   <translation>&amp;Lauf öffnen</translation>
  </message>
  <message>
   <source>Page</source>
   <translation>Seite</translation>
  </message>
  <message>
   <source>{0} (stale: run again)</source>
   <translation>{0} (veraltet: erneut rechnen)</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>Lauf</translation>
  </message>
  <message>
   <source>Tangent at the key</source>
   <translation>Tangente an der Stützstelle</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Selbsttätig</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Corner</source>
   <translation>Ecke</translation>
  </message>
  <message>
   <source>Given velocity</source>
   <translation>Gegebene Geschwindigkeit</translation>
  </message>
  <message>
   <source>Automatic: from the neighbouring keys. Stop: the part comes to rest. Corner: straight on both sides. Given velocity: as entered below</source>
   <translation>Selbsttätig: aus den benachbarten Stützstellen. Anhalten: Das Teil kommt zur Ruhe. Ecke: beiderseits gerade. Gegebene Geschwindigkeit: wie unten eingegeben</translation>
  </message>
  <message>
   <source>Velocity along {0} (mm/s)</source>
   <translation>Geschwindigkeit entlang {0} (mm/s)</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Keine</translation>
  </message>
  <message>
   <source>Linear</source>
   <translation>Linear</translation>
  </message>
  <message>
   <source>Screw</source>
   <translation>Schraubung</translation>
  </message>
  <message>
   <source>Spline</source>
   <translation>Spline</translation>
  </message>
  <message>
   <source>Absolute</source>
   <translation>Absolut</translation>
  </message>
  <message>
   <source>Relative</source>
   <translation>Relativ</translation>
  </message>
  <message>
   <source>RelativeToFirst</source>
   <translation>Relativ zur ersten</translation>
  </message>
  <message>
   <source>Consistent</source>
   <translation>Stimmig</translation>
  </message>
  <message>
   <source>DualContouring</source>
   <translation>DualContouring</translation>
  </message>
  <message>
   <source>DualMarchingCubes</source>
   <translation>DualMarchingCubes</translation>
  </message>
  <message>
   <source>Equivalence</source>
   <translation>Äquivalenz</translation>
  </message>
  <message>
   <source>Greedy</source>
   <translation>Gierig</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>Off</source>
   <translation>Aus</translation>
  </message>
  <message>
   <source>Session</source>
   <translation>Sitzung</translation>
  </message>
  <message>
   <source>Document</source>
   <translation>Dokument</translation>
  </message>
  <message>
   <source>input</source>
   <translation>Eingabe</translation>
  </message>
  <message>
   <source>motion</source>
   <translation>Bewegung</translation>
  </message>
  <message>
   <source>sampling</source>
   <translation>Abtasten</translation>
  </message>
  <message>
   <source>signs</source>
   <translation>Innen und außen</translation>
  </message>
  <message>
   <source>contour</source>
   <translation>Oberfläche</translation>
  </message>
  <message>
   <source>simplify</source>
   <translation>Vereinfachen</translation>
  </message>
  <message>
   <source>check</source>
   <translation>Prüfen</translation>
  </message>
  <message>
   <source>export</source>
   <translation>Schreiben</translation>
  </message>
  <message>
   <source>straight moves</source>
   <translation>gerade Züge</translation>
  </message>
  <message>
   <source>moves without turns</source>
   <translation>Züge ohne Drehung</translation>
  </message>
  <message>
   <source>moves with turns</source>
   <translation>Züge mit Drehung</translation>
  </message>
  <message>
   <source>polish</source>
   <translation>glätten</translation>
  </message>
  <message>
   <source>done</source>
   <translation>fertig</translation>
  </message>
  <message>
   <source>{0}, {1} s</source>
   <translation>{0}, {1} s</translation>
  </message>
  <message>
   <source>Progress</source>
   <translation>Fortschritt</translation>
  </message>
  <message>
   <source>Nothing</source>
   <translation>Nichts</translation>
  </message>
  <message>
   <source>Face</source>
   <translation>Fläche</translation>
  </message>
  <message>
   <source>Kind</source>
   <translation>Art</translation>
  </message>
 </context>
 <context>
  <name>SweptVolume_Properties</name>
  <message>
   <source>Envelope whose parts and motion are checked; it is coloured by distance</source>
   <translation>Hülle, deren Teile und Bewegung geprüft werden; sie wird nach Abstand eingefärbt</translation>
  </message>
  <message>
   <source>Parts that move together, if no envelope is given</source>
   <translation>Gemeinsam bewegte Teile, wenn keine Hülle angegeben ist</translation>
  </message>
  <message>
   <source>Motion of the parts, if no envelope is given</source>
   <translation>Bewegung der Teile, wenn keine Hülle angegeben ist</translation>
  </message>
  <message>
   <source>Parts that stand still; groups and links stand for what they contain</source>
   <translation>Stillstehende Teile; Gruppen und Verknüpfungen stehen für ihren Inhalt</translation>
  </message>
  <message>
   <source>All other visible parts are neighbours, instead of Neighbours</source>
   <translation>Alle anderen sichtbaren Teile sind Nachbarn, statt Neighbours</translation>
  </message>
  <message>
   <source>Distance from the neighbours that the motion must keep</source>
   <translation>Abstand von den Nachbarn, den die Bewegung einhalten muss</translation>
  </message>
  <message>
   <source>Largest error of the smallest distance</source>
   <translation>Größter Fehler des kleinsten Abstands</translation>
  </message>
  <message>
   <source>How far the triangles of solids may deviate from them; it is subtracted from guaranteed distances</source>
   <translation>Wie weit die Dreiecke von Festkörpern von ihnen abweichen dürfen; es wird vom gesicherten Abstand abgezogen</translation>
  </message>
  <message>
   <source>Neighbours, or groups of them, that have a rule of their own</source>
   <translation>Nachbarn, oder Gruppen von ihnen, mit eigener Regel</translation>
  </message>
  <message>
   <source>The rule of each of RuleParts: Required (its own required distance), Contact (contact is allowed), Ignore (not checked)</source>
   <translation>Die Regel von jedem der RuleParts: Required (eigener Sollabstand), Contact (Kontakt erlaubt), Ignore (nicht geprüft)</translation>
  </message>
  <message>
   <source>For each of RuleParts, in mm: its required distance, or how deep the parts may overlap in allowed contact</source>
   <translation>Für jedes der RuleParts, in mm: sein Sollabstand, oder wie tief sich die Teile bei erlaubtem Kontakt durchdringen dürfen</translation>
  </message>
  <message>
   <source>State of the result</source>
   <translation>Zustand des Ergebnisses</translation>
  </message>
  <message>
   <source>Why the last run failed; notes</source>
   <translation>Warum der letzte Lauf fehlschlug; Hinweise</translation>
  </message>
  <message>
   <source>Result in one line</source>
   <translation>Ergebnis in einer Zeile</translation>
  </message>
  <message>
   <source>Neighbours checked</source>
   <translation>Geprüfte Nachbarn</translation>
  </message>
  <message>
   <source>Worst verdict of all rows: clear, below (below required), contact or clash</source>
   <translation>Schlechtestes Urteil aller Zeilen: clear (frei), below (unter Sollabstand), contact (Kontakt) oder clash (Kollision)</translation>
  </message>
  <message>
   <source>Smallest distance</source>
   <translation>Kleinster Abstand</translation>
  </message>
  <message>
   <source>Report of the run (JSON)</source>
   <translation>Bericht des Laufs (JSON)</translation>
  </message>
  <message>
   <source>Distance at each point</source>
   <translation>Abstand an jedem Punkt</translation>
  </message>
  <message>
   <source>Inputs of the stored result</source>
   <translation>Eingaben des gespeicherten Ergebnisses</translation>
  </message>
  <message>
   <source>Inputs of the last run that failed</source>
   <translation>Eingaben des letzten fehlgeschlagenen Laufs</translation>
  </message>
  <message>
   <source>Inputs that were deleted (JSON)</source>
   <translation>Eingaben, die gelöscht wurden (JSON)</translation>
  </message>
  <message>
   <source>Parts that AllVisible found, to notice when they change</source>
   <translation>Teile, die AllVisible fand, um ihre Änderung zu bemerken</translation>
  </message>
  <message>
   <source>What made each triangle (packed)</source>
   <translation>Was jedes Dreieck erzeugt hat (gepackt)</translation>
  </message>
  <message>
   <source>Where the result was put in the document</source>
   <translation>Wohin das Ergebnis im Dokument gelegt wurde</translation>
  </message>
  <message>
   <source>Solids and meshes that move together; groups and links stand for what they contain</source>
   <translation>Gemeinsam bewegte Festkörper und Netze; Gruppen und Verknüpfungen stehen für ihren Inhalt</translation>
  </message>
  <message>
   <source>Motion of the parts</source>
   <translation>Bewegung der Teile</translation>
  </message>
  <message>
   <source>One motion for each of MovingParts, if they move independently; empty: all follow Motion</source>
   <translation>Je eine Bewegung für MovingParts, wenn sie sich unabhängig bewegen; leer: alle folgen Motion</translation>
  </message>
  <message>
   <source>Moving part relative to which the envelope is computed</source>
   <translation>Bewegtes Teil, relativ zu dem die Hülle berechnet wird</translation>
  </message>
  <message>
   <source>Motion of the reference part</source>
   <translation>Bewegung des Bezugsteils</translation>
  </message>
  <message>
   <source>Cells along the longest side of the swept volume; used while CellSize is 0</source>
   <translation>Zellen entlang der längsten Seite des überstrichenen Volumens; gilt, solange CellSize 0 ist</translation>
  </message>
  <message>
   <source>Edge length of a cell of the sampling grid; 0: derived from Resolution</source>
   <translation>Kantenlänge einer Zelle des Abtastgitters; 0: aus Resolution</translation>
  </message>
  <message>
   <source>How far the triangles of a solid may deviate from it, in cells</source>
   <translation>Wie weit die Dreiecke eines Festkörpers von ihm abweichen dürfen, in Zellen</translation>
  </message>
  <message>
   <source>How far simplification may move the surface; 0: no simplification</source>
   <translation>Wie weit Vereinfachung die Oberfläche verschieben darf; 0: keine Vereinfachung</translation>
  </message>
  <message>
   <source>Distance by which the envelope is grown on all sides</source>
   <translation>Abstand, um den die Hülle auf allen Seiten wächst</translation>
  </message>
  <message>
   <source>The envelope provably contains the swept volume</source>
   <translation>Die Hülle enthält nachweislich den überstrichenen Raum</translation>
  </message>
  <message>
   <source>Keep sealed hollow spaces as inner shells</source>
   <translation>Abgeschlossene Hohlräume als innere Schalen behalten</translation>
  </message>
  <message>
   <source>A pose is skipped if no point of the part has moved farther than this since the last pose used; 0: none is skipped</source>
   <translation>Eine Lage wird übersprungen, wenn sich seit der letzten verwendeten kein Punkt des Teils weiter als dies bewegt hat; 0: keine</translation>
  </message>
  <message>
   <source>How pieces of surface inside one cell are separated</source>
   <translation>Wie Flächenstücke in einer Zelle getrennt werden</translation>
  </message>
  <message>
   <source>Processor that samples the envelope</source>
   <translation>Prozessor, der die Hülle abtastet</translation>
  </message>
  <message>
   <source>Whether to record which face or edge made each triangle. Off: no. Session: until the document is closed. Document: stored in the document, which makes the file larger</source>
   <translation>Ob aufgezeichnet wird, welche Fläche oder Kante jedes Dreieck erzeugt hat. Off: nein. Session: bis das Dokument geschlossen wird. Document: im Dokument gespeichert, was die Datei vergrößert</translation>
  </message>
  <message>
   <source>Why the last run failed; warnings</source>
   <translation>Warum der letzte Lauf fehlschlug; Warnungen</translation>
  </message>
  <message>
   <source>Volume of the envelope</source>
   <translation>Volumen der Hülle</translation>
  </message>
  <message>
   <source>Area of the envelope</source>
   <translation>Fläche der Hülle</translation>
  </message>
  <message>
   <source>Triangles of the envelope</source>
   <translation>Dreiecke der Hülle</translation>
  </message>
  <message>
   <source>Closed surfaces of the envelope</source>
   <translation>Geschlossene Flächen der Hülle</translation>
  </message>
  <message>
   <source>Pairs of triangles that cross each other; -1: not counted</source>
   <translation>Paare sich schneidender Dreiecke; -1: nicht gezählt</translation>
  </message>
  <message>
   <source>Edge of a cell in this result</source>
   <translation>Kante einer Zelle in diesem Ergebnis</translation>
  </message>
  <message>
   <source>Duration of the run (s)</source>
   <translation>Dauer des Laufs (s)</translation>
  </message>
  <message>
   <source>Parts that move, in the order of Motions</source>
   <translation>Bewegte Teile, in der Reihenfolge von Motions</translation>
  </message>
  <message>
   <source>One motion for each of MovingParts, on a common time axis</source>
   <translation>Je eine Bewegung für MovingParts, auf gemeinsamer Zeitachse</translation>
  </message>
  <message>
   <source>All other visible parts are neighbours that stand still, instead of Neighbours</source>
   <translation>Alle anderen sichtbaren Teile sind stillstehende Nachbarn, statt Neighbours</translation>
  </message>
  <message>
   <source>Pairs of parts that come nearer than this are listed; 0: a tenth of the size of the parts</source>
   <translation>Paare von Teilen, die sich näher kommen, werden aufgeführt; 0: ein Zehntel der Größe der Teile</translation>
  </message>
  <message>
   <source>Pairs of parts, or of groups, that have a rule of their own: first, second, first ...</source>
   <translation>Paare von Teilen oder Gruppen mit eigener Regel: erstes, zweites, erstes ...</translation>
  </message>
  <message>
   <source>For each pair of RuleParts, in mm: its required distance, or how deep the parts may overlap in allowed contact</source>
   <translation>Für jedes Paar von RuleParts, in mm: sein Sollabstand, oder wie tief sich die Teile bei erlaubtem Kontakt durchdringen dürfen</translation>
  </message>
  <message>
   <source>Number of pairs checked, including those beyond Range</source>
   <translation>Anzahl der geprüften Paare, auch jener außerhalb von Range</translation>
  </message>
  <message>
   <source>Time of each pose (s), in ascending order</source>
   <translation>Zeit jeder Lage (s), aufsteigend</translation>
  </message>
  <message>
   <source>Pose of the moving part at each time</source>
   <translation>Lage des bewegten Teils zu jeder Zeit</translation>
  </message>
  <message>
   <source>How the part moves between two poses. Linear: straight line at a constant rate of turn. Screw: one screw movement. Spline: smooth curve through all poses. None: the part only appears at the poses</source>
   <translation>Wie sich das Teil zwischen zwei Lagen bewegt. Linear: gerade Linie mit gleichmäßiger Drehung. Screw: eine Schraubbewegung. Spline: glatte Kurve durch alle Lagen. None: das Teil erscheint nur in den Lagen</translation>
  </message>
  <message>
   <source>Point of the part that moves along the straight line (Linear) or the curve (Spline) between two poses. In coordinates of the part if PoseType is Absolute, else of the document</source>
   <translation>Punkt des Teils, der zwischen zwei Lagen der Geraden (Linear) oder der Kurve (Spline) folgt. In Koordinaten des Teils, wenn PoseType Absolute ist, sonst des Dokuments</translation>
  </message>
  <message>
   <source>Parts that this motion moves; the motion editor shows the first one</source>
   <translation>Teile, die diese Bewegung bewegt; der Bewegungseditor zeigt das erste</translation>
  </message>
  <message>
   <source>Other parts that the source moved when this motion was read</source>
   <translation>Andere Teile, die die Quelle beim Lesen dieser Bewegung bewegte</translation>
  </message>
  <message>
   <source>Spline: the tangent at each pose. Auto: from the neighbouring poses. Stop, Corner, or Given: from Velocities. Missing entries are Auto</source>
   <translation>Spline: die Tangente an jeder Lage. Auto: aus den benachbarten Lagen. Stop, Corner, oder Given: aus Velocities. Fehlende Einträge sind Auto</translation>
  </message>
  <message>
   <source>Spline: velocity at each pose whose tangent is Given (mm/s)</source>
   <translation>Spline: Geschwindigkeit an jeder Lage, deren Tangente Given ist (mm/s)</translation>
  </message>
  <message>
   <source>Where the poses come from</source>
   <translation>Woher die Lagen kommen</translation>
  </message>
  <message>
   <source>File of the poses; Reload motion reads it again</source>
   <translation>Datei der Lagen; Bewegung neu laden liest sie wieder</translation>
  </message>
  <message>
   <source>Unit of the lengths in the file</source>
   <translation>Einheit der Längen in der Datei</translation>
  </message>
  <message>
   <source>Objects whose placements or shape give the poses</source>
   <translation>Objekte, deren Platzierungen oder Form die Lagen geben</translation>
  </message>
  <message>
   <source>Settings of the source</source>
   <translation>Einstellungen der Quelle</translation>
  </message>
  <message>
   <source>Number of poses</source>
   <translation>Anzahl der Lagen</translation>
  </message>
  <message>
   <source>Last time minus first time (s)</source>
   <translation>Letzte minus erste Zeit (s)</translation>
  </message>
  <message>
   <source>Empty if the motion can be used, else what is wrong</source>
   <translation>Leer, wenn die Bewegung verwendbar ist, sonst was nicht stimmt</translation>
  </message>
  <message>
   <source>Remarks about the poses as they were read</source>
   <translation>Hinweise zu den gelesenen Lagen</translation>
  </message>
  <message>
   <source>State of the source when it was read</source>
   <translation>Zustand der Quelle, als sie gelesen wurde</translation>
  </message>
  <message>
   <source>Number of poses; for a curve 0: as many as SourceAccuracy needs</source>
   <translation>Anzahl der Lagen; bei einer Kurve 0: so viele, wie SourceAccuracy erfordert</translation>
  </message>
  <message>
   <source>How far the straight line between two poses may deviate from the curve</source>
   <translation>Wie weit die Gerade zwischen zwei Lagen von der Kurve abweichen darf</translation>
  </message>
  <message>
   <source>Fixed: the part never turns. Tangent: x of the part stays on the tangent. SecondCurve: z points to the second curve</source>
   <translation>Fixed: Das Teil dreht sich nie. Tangent: x des Teils bleibt auf der Tangente. SecondCurve: z zeigt zur zweiten Kurve</translation>
  </message>
  <message>
   <source>Time from the first to the last pose (s)</source>
   <translation>Zeit von der ersten bis zur letzten Lage (s)</translation>
  </message>
  <message>
   <source>Time from one pose to the next (s)</source>
   <translation>Zeit von einer Lage zur nächsten (s)</translation>
  </message>
  <message>
   <source>Rapid</source>
   <translation>Eilgang</translation>
  </message>
  <message>
   <source>What the words A, B and C rotate: the tool head or the table</source>
   <translation>Was die Wörter A, B und C drehen: den Werkzeugkopf oder den Tisch</translation>
  </message>
  <message>
   <source>Name of the value that is driven</source>
   <translation>Name des Werts, der angetrieben wird</translation>
  </message>
  <message>
   <source>Driven value at the first pose, in its unit (mm, degrees)</source>
   <translation>Angetriebener Wert bei der ersten Lage, in seiner Einheit (mm, Grad)</translation>
  </message>
  <message>
   <source>Driven value at the last pose, in its unit (mm, degrees)</source>
   <translation>Angetriebener Wert bei der letzten Lage, in seiner Einheit (mm, Grad)</translation>
  </message>
  <message>
   <source>Parts, in the order in which they are installed</source>
   <translation>Teile, in der Reihenfolge ihres Einbaus</translation>
  </message>
  <message>
   <source>One motion for each part, which ends at its installed position</source>
   <translation>Je Teil eine Bewegung, die in seiner Einbaulage endet</translation>
  </message>
  <message>
   <source>Distance that each part must keep from everything already in place</source>
   <translation>Abstand, den jedes Teil von allem einhalten muss, was schon da ist</translation>
  </message>
  <message>
   <source>Within this distance of its start and end, a part may touch what it touches there</source>
   <translation>Bis zu diesem Abstand von Start und Ziel darf ein Teil berühren, was es dort berührt</translation>
  </message>
  <message>
   <source>Parts that have a path</source>
   <translation>Teile, die eine Bahn haben</translation>
  </message>
  <message>
   <source>First side: parts, envelopes or other reserved spaces</source>
   <translation>Erste Seite: Teile, Hüllen oder andere reservierte Räume</translation>
  </message>
  <message>
   <source>Second side: parts, envelopes or other reserved spaces</source>
   <translation>Zweite Seite: Teile, Hüllen oder andere reservierte Räume</translation>
  </message>
  <message>
   <source>Motion that moves the first side; none: it stands still</source>
   <translation>Bewegung der ersten Seite; keine: sie steht still</translation>
  </message>
  <message>
   <source>Motion that moves the second side; none: it stands still</source>
   <translation>Bewegung der zweiten Seite; keine: sie steht still</translation>
  </message>
  <message>
   <source>Time at which both sides are compared (s)</source>
   <translation>Zeit, zu der beide Seiten verglichen werden (s)</translation>
  </message>
  <message>
   <source>How far the triangles of solids may deviate from them</source>
   <translation>Wie weit die Dreiecke von Festkörpern von ihnen abweichen dürfen</translation>
  </message>
  <message>
   <source>Whether the result is current</source>
   <translation>Ob das Ergebnis aktuell ist</translation>
  </message>
  <message>
   <source>Remarks about the result</source>
   <translation>Hinweise zum Ergebnis</translation>
  </message>
  <message>
   <source>Volume that both share</source>
   <translation>Volumen, das beide gemeinsam haben</translation>
  </message>
  <message>
   <source>Smallest distance, if they share no volume</source>
   <translation>Kleinster Abstand, wenn sie kein Volumen gemeinsam haben</translation>
  </message>
  <message>
   <source>How deep one side penetrates the other</source>
   <translation>Wie tief eine Seite in die andere eindringt</translation>
  </message>
  <message>
   <source>Envelope or other closed mesh that is converted to a solid</source>
   <translation>Hülle oder anderes geschlossenes Netz, das in einen Festkörper umgewandelt wird</translation>
  </message>
  <message>
   <source>Merge coplanar</source>
   <translation>Koplanare vereinigen</translation>
  </message>
  <message>
   <source>Largest number of faces; if Tolerance is 0, the smallest tolerance that stays within it is chosen</source>
   <translation>Größte Anzahl der Flächen; ist Tolerance 0, wird die kleinste Toleranz gewählt, die sie einhält</translation>
  </message>
  <message>
   <source>How far the solid may deviate from the mesh. Within it, cylinders, spheres and other surfaces are recognised, and the rest is simplified. 0: exact, unless MaxFaces needs a tolerance</source>
   <translation>Wie weit der Festkörper vom Netz abweichen darf. Innerhalb davon werden Zylinder, Kugeln und andere Flächen erkannt, der Rest wird vereinfacht. 0: genau, sofern MaxFaces keine Toleranz erfordert</translation>
  </message>
  <message>
   <source>Largest distance of the mesh from the solid, as measured</source>
   <translation>Größter gemessener Abstand des Netzes vom Festkörper</translation>
  </message>
  <message>
   <source>Largest gap between two faces that share an edge</source>
   <translation>Größter Spalt zwischen zwei Flächen mit gemeinsamer Kante</translation>
  </message>
  <message>
   <source>Why the last run failed</source>
   <translation>Warum der letzte Lauf fehlschlug</translation>
  </message>
  <message>
   <source>Faces of the solid</source>
   <translation>Flächen des Festkörpers</translation>
  </message>
  <message>
   <source>Volume of the solid</source>
   <translation>Volumen des Festkörpers</translation>
  </message>
  <message>
   <source>Study file (TOML) that lists the runs; empty: the runs are those of Sources</source>
   <translation>Studiendatei (TOML) mit den Läufen; leer: die Läufe sind die von Sources</translation>
  </message>
  <message>
   <source>Envelopes and clearance checks of the document: one run for each</source>
   <translation>Hüllen und Abstandsprüfungen des Dokuments: je ein Lauf</translation>
  </message>
  <message>
   <source>Folder for results; empty: the one that the file names, or one beside the document</source>
   <translation>Ordner für Ergebnisse; leer: der in der Datei genannte oder einer neben dem Dokument</translation>
  </message>
  <message>
   <source>Runs at once; 0: one for each core</source>
   <translation>Läufe gleichzeitig; 0: einer je Kern</translation>
  </message>
  <message>
   <source>Runs that have ended</source>
   <translation>Läufe, die beendet sind</translation>
  </message>
  <message>
   <source>Folder of the stored result</source>
   <translation>Ordner des gespeicherten Ergebnisses</translation>
  </message>
  <message>
   <source>Study file of the stored result</source>
   <translation>Studiendatei des gespeicherten Ergebnisses</translation>
  </message>
  <message>
   <source>What a pose means.
Absolute: the placement the part has at that time, instead of the one it has now (default; captured placements and recorded motions are of this kind).
Relative: a displacement on top of where the part stands now; the identity leaves it there.
RelativeToFirst: as Relative, measured from the first pose: the motion starts where the part stands now.
Several parts move rigidly together; Absolute places the first of them. A motion in a group counts in the coordinates of the group, and moves with it.</source>
   <translation>Was eine Lage bedeutet.
Absolut: die Platzierung des Teils zu dieser Zeit anstelle der jetzigen (Vorgabe; so sind übernommene Platzierungen und aufgezeichnete Bewegungen).
Relativ: eine Verschiebung gegenüber dem jetzigen Stand; die Einheit lässt es dort.
Relativ zur ersten: wie Relativ, gemessen von der ersten Lage: Die Bewegung beginnt, wo das Teil jetzt steht.
Mehrere Teile bewegen sich starr zusammen; Absolut setzt das erste davon. Eine Bewegung in einer Gruppe gilt in deren Koordinaten und bewegt sich mit ihr.</translation>
  </message>
  <message>
   <source>Number of triangles to which a large mesh is reduced on screen; 0: all are drawn</source>
   <translation>Anzahl der Dreiecke, auf die ein großes Netz am Bildschirm reduziert wird; 0: alle werden gezeichnet</translation>
  </message>
  <message>
   <source>What the colours show, if Made by was recorded</source>
   <translation>Was die Farben zeigen, wenn „Erzeugt von“ aufgezeichnet wurde</translation>
  </message>
  <message>
   <source>Length of the axes drawn at each pose (mm); 0: automatic</source>
   <translation>Länge der Achsen an jeder Lage (mm); 0: automatisch</translation>
  </message>
  <message>
   <source>Width of the line of the motion (pixels)</source>
   <translation>Breite der Linie der Bewegung (Pixel)</translation>
  </message>
 </context>
 <context>
  <name>SweptVolume_Workbench</name>
  <message>
   <source>Swept Volume</source>
   <translation>Überstrichener Raum</translation>
  </message>
  <message>
   <source>The space that moving parts need: motions, swept envelopes, solids, STEP</source>
   <translation>Der Raum, den bewegte Teile brauchen: Bewegungen, Hüllen, Festkörper, STEP</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <source>Swept Volume</source>
   <translation>Überstrichener Raum</translation>
  </message>
  <message>
   <source>&amp;Swept Volume</source>
   <translation>Überstri&amp;chener Raum</translation>
  </message>
 </context>
</TS>
