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
   <source>Cells along the longest side</source>
   <translation>Zellen entlang der längsten Seite</translation>
  </message>
  <message>
   <source>Of a new envelope</source>
   <translation>Für eine neue Hülle</translation>
  </message>
  <message>
   <source>Simplification</source>
   <translation>Vereinfachung</translation>
  </message>
  <message>
   <source>Largest deviation by simplification of a new envelope; 0: none</source>
   <translation>Größte Abweichung durch Vereinfachung einer neuen Hülle; 0: keine</translation>
  </message>
  <message>
   <source>Backend</source>
   <translation>Rechenwerk</translation>
  </message>
  <message>
   <source>Where the sampling of a new envelope runs</source>
   <translation>Wo die Abtastung einer neuen Hülle läuft</translation>
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
   <source>One core fewer than there are keeps the window quick while a large envelope runs</source>
   <translation>Ein Kern weniger als vorhanden hält das Fenster flink, während eine große Hülle gerechnet wird</translation>
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
   <source>A run that needs more is refused before it starts</source>
   <translation>Ein Lauf, der mehr braucht, wird vor dem Start abgelehnt</translation>
  </message>
  <message>
   <source> MiB</source>
   <translation> MiB</translation>
  </message>
  <message>
   <source>three quarters of what is free</source>
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
   <source>HTML with placeholders for reports and studies; empty: the workbench's own</source>
   <translation>HTML mit Platzhaltern für Berichte und Studien; leer: die der Arbeitsumgebung</translation>
  </message>
  <message>
   <source>Template of PDF</source>
   <translation>Vorlage für PDF</translation>
  </message>
  <message>
   <source>The same for PDF, in the simple HTML of Qt's text documents; empty: the workbench's own</source>
   <translation>Dasselbe für PDF, im einfachen HTML der Textdokumente von Qt; leer: die der Arbeitsumgebung</translation>
  </message>
  <message>
   <source>Path editor</source>
   <translation>Bahneditor</translation>
  </message>
  <message>
   <source>Cells of the preview</source>
   <translation>Zellen der Vorschau</translation>
  </message>
  <message>
   <source>Of the coarse envelope that follows the path editor</source>
   <translation>Für die grobe Hülle, die dem Bahneditor folgt</translation>
  </message>
  <message>
   <source>Show a coarse envelope while a path is edited</source>
   <translation>Beim Bearbeiten einer Bahn eine grobe Hülle zeigen</translation>
  </message>
 </context>
 <context>
  <name>SweptVolume_Commands</name>
  <message>
   <source>Check clearance</source>
   <translation>Abstand prüfen</translation>
  </message>
  <message>
   <source>Smallest distance of the moving parts to every neighbour over the whole motion. Select an envelope, or parts and a motion, or an earlier check</source>
   <translation>Kleinster Abstand der bewegten Teile zu jedem Nachbarn über die ganze Bewegung. Eine Hülle, Teile und eine Bewegung oder eine frühere Prüfung auswählen</translation>
  </message>
  <message>
   <source>Check mechanism</source>
   <translation>Mechanismus prüfen</translation>
  </message>
  <message>
   <source>Smallest distance between each two of several parts that move at the same time, over the whole motion. Select their motions, or an earlier check; else all motions that know their parts are taken</source>
   <translation>Kleinster Abstand zwischen je zwei von mehreren Teilen, die sich gleichzeitig bewegen, über die ganze Bewegung. Ihre Bewegungen oder eine frühere Prüfung auswählen; sonst werden alle Bewegungen genommen, die ihre Teile kennen</translation>
  </message>
  <message>
   <source>Check reserved spaces</source>
   <translation>Reservierte Räume prüfen</translation>
  </message>
  <message>
   <source>How near envelopes, their solids or parts are to each other as they stand, and the space that two of them share. Select two or more; of a selected shared volume: computes it again</source>
   <translation>Wie nahe Hüllen, ihre Festkörper oder Teile einander sind, so wie sie stehen, und der Raum, den zwei von ihnen gemeinsam haben. Zwei oder mehr auswählen; ein ausgewähltes gemeinsames Volumen wird neu berechnet</translation>
  </message>
  <message>
   <source>Create envelope...</source>
   <translation>Hülle erzeugen …</translation>
  </message>
  <message>
   <source>Computes the space that the selected parts need along a motion. Select solids or meshes, also inside groups and links, and a motion</source>
   <translation>Berechnet den Raum, den die ausgewählten Teile auf einer Bewegung brauchen. Festkörper oder Netze auswählen, auch in Gruppen und Verknüpfungen, und eine Bewegung</translation>
  </message>
  <message>
   <source>Open the demo</source>
   <translation>Beispiel öffnen</translation>
  </message>
  <message>
   <source>Opens the example: a starter motor is fitted past its neighbours</source>
   <translation>Öffnet das Beispiel: Ein Anlasser wird an seinen Nachbarn vorbei eingebaut</translation>
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
   <source>Edits the keys of the selected motion in a table, plays it with a ghost of the part</source>
   <translation>Bearbeitet die Schlüssel der ausgewählten Bewegung in einer Tabelle und spielt sie mit einem Geisterbild des Teils ab</translation>
  </message>
  <message>
   <source>Settings of the source...</source>
   <translation>Einstellungen der Quelle...</translation>
  </message>
  <message>
   <source>Changes what the source of the selected motion is asked for (accuracy, orientation, duration, range, unit) and reads it again</source>
   <translation>Ändert, was von der Quelle der gewählten Bewegung verlangt wird (Genauigkeit, Ausrichtung, Dauer, Bereich, Einheit), und liest sie neu</translation>
  </message>
  <message>
   <source>Export envelope...</source>
   <translation>Hülle exportieren …</translation>
  </message>
  <message>
   <source>Writes the selected envelope as STEP, BREP, STL, PLY, OBJ, OFF or 3MF, checked on the way; a selected solid's tolerance and limits are taken</source>
   <translation>Schreibt die gewählte Hülle als STEP, BREP, STL, PLY, OBJ, OFF oder 3MF und prüft sie dabei; Toleranz und Grenzen eines gewählten Festkörpers gelten auch hier</translation>
  </message>
  <message>
   <source>Export report...</source>
   <translation>Bericht exportieren ...</translation>
  </message>
  <message>
   <source>Writes what the selected check or study found as one HTML file, with a 3D view of a check, or as PDF</source>
   <translation>Schreibt, was die gewählte Prüfung oder Studie ergab, als eine HTML-Datei, mit 3D-Ansicht einer Prüfung, oder als PDF</translation>
  </message>
  <message>
   <source>Find path...</source>
   <translation>Weg finden...</translation>
  </message>
  <message>
   <source>Finds how the selected part gets to its place between the others, clear of them all the way. More selected parts are its neighbours; a selected motion gives start and goal</source>
   <translation>Findet, wie das gewählte Teil zwischen den anderen an seinen Platz kommt, auf dem ganzen Weg frei von ihnen. Weitere gewählte Teile sind seine Nachbarn; eine gewählte Bewegung gibt Start und Ziel</translation>
  </message>
  <message>
   <source>Improve path...</source>
   <translation>Weg verbessern...</translation>
  </message>
  <message>
   <source>Leads the selected motion round what it clashes with, makes it shorter with fewer keys, or gives it more clearance. The motion stays; the better one comes beside it</source>
   <translation>Führt die gewählte Bewegung um das herum, womit sie kollidiert, macht sie kürzer mit weniger Schlüsseln oder gibt ihr mehr Abstand. Die Bewegung bleibt; die bessere kommt daneben</translation>
  </message>
  <message>
   <source>What made this?</source>
   <translation>Was hat das erzeugt?</translation>
  </message>
  <message>
   <source>Colours the selected envelope by the faces that made it; a click on it tells which face or edge of which part passed there, and when</source>
   <translation>Färbt die gewählte Hülle nach den Flächen, die sie erzeugt haben; ein Klick darauf sagt, welche Fläche oder Kante welches Teils dort vorbeikam, und wann</translation>
  </message>
  <message>
   <source>Make solid</source>
   <translation>Festkörper erzeugen</translation>
  </message>
  <message>
   <source>Makes a solid of the selected envelope for booleans, measuring and STEP; of a selected solid: makes it again</source>
   <translation>Erzeugt aus der ausgewählten Hülle einen Festkörper für boolesche Operationen, Messen und STEP; ein ausgewählter Festkörper wird neu erzeugt</translation>
  </message>
  <message>
   <source>Motion from driven value...</source>
   <translation>Bewegung aus gesteuertem Wert...</translation>
  </message>
  <message>
   <source>Makes a motion of a part while a value runs through a range: a spreadsheet cell, a sketch dimension, a variable of an assembly. Select the object with the value, then the part; without a part, motions of all parts that move</source>
   <translation>Macht eine Bewegung eines Teils, während ein Wert einen Bereich durchläuft: eine Zelle einer Tabelle, ein Maß einer Skizze, eine Variable einer Baugruppe. Das Objekt mit dem Wert auswählen, dann das Teil; ohne Teil entstehen Bewegungen aller Teile, die sich bewegen</translation>
  </message>
  <message>
   <source>Motion from file...</source>
   <translation>Bewegung aus Datei …</translation>
  </message>
  <message>
   <source>Reads a motion from a CSV file: time, position and quaternion (t,tx,ty,tz,qx,qy,qz,qw) or 16 matrix numbers a row</source>
   <translation>Liest eine Bewegung aus einer CSV-Datei: Zeit, Ort und Quaternion (t,tx,ty,tz,qx,qy,qz,qw) oder 16 Matrixzahlen je Zeile</translation>
  </message>
  <message>
   <source>Motion from selected placements</source>
   <translation>Bewegung aus ausgewählten Platzierungen</translation>
  </message>
  <message>
   <source>Makes a motion from the placements of the selected objects, in the order of selection. It stays linked: moving an object moves its pose</source>
   <translation>Erzeugt eine Bewegung aus den Platzierungen der ausgewählten Objekte in der Reihenfolge der Auswahl. Sie bleibt verknüpft: Wird ein Objekt bewegt, bewegt sich seine Lage</translation>
  </message>
  <message>
   <source>Motion from path object...</source>
   <translation>Bewegung aus Bahnobjekt …</translation>
  </message>
  <message>
   <source>Makes a motion from the selected wire, sketch, robot trajectory, link or Draft array, or CAM path; from a path and a second curve that orients; from an assembly simulation, of a part or of all that move. It stays linked to it</source>
   <translation>Macht eine Bewegung aus dem gewählten Draht, der Skizze, Roboterbahn, Link- oder Draft-Anordnung oder CAM-Bahn; aus einer Bahn und einer zweiten Kurve, die ausrichtet; aus der Simulation einer Baugruppe, von einem Teil oder von allen, die sich bewegen. Sie bleibt damit verknüpft</translation>
  </message>
  <message>
   <source>New motion...</source>
   <translation>Neue Bewegung …</translation>
  </message>
  <message>
   <source>Opens the path editor: move the selected part step by step and capture its placements</source>
   <translation>Öffnet den Bahneditor: das ausgewählte Teil Schritt für Schritt bewegen und seine Platzierungen übernehmen</translation>
  </message>
  <message>
   <source>Recompute envelope</source>
   <translation>Hülle neu berechnen</translation>
  </message>
  <message>
   <source>Computes the selected envelope again from its present parts and motion; without a selection the first one that is stale</source>
   <translation>Berechnet die ausgewählte Hülle neu aus ihren jetzigen Teilen und ihrer Bewegung; ohne Auswahl die erste veraltete</translation>
  </message>
  <message>
   <source>Reload motion</source>
   <translation>Bewegung neu laden</translation>
  </message>
  <message>
   <source>Reads the file or the source of the selected motion again; all motions of one driver or simulation together</source>
   <translation>Liest die Datei oder die Quelle der gewählten Bewegung neu; alle Bewegungen eines Antriebs oder einer Simulation zusammen</translation>
  </message>
  <message>
   <source>Sequence...</source>
   <translation>Einbaufolge...</translation>
  </message>
  <message>
   <source>Installs the selected parts one after the other, each clear of all that is there by then: finds their ways in this order, or an order, and plays them as one. Or opens the selected sequence</source>
   <translation>Baut die gewählten Teile nacheinander ein, jedes frei von allem, was bis dahin da ist: findet ihre Wege in dieser Reihenfolge oder eine Reihenfolge und spielt sie als ein Ganzes ab. Oder öffnet die gewählte Einbaufolge</translation>
  </message>
  <message>
   <source>Study...</source>
   <translation>Studie...</translation>
  </message>
  <message>
   <source>Many runs, several at once: those of a study file, or the envelopes and clearance checks of the document. Select some of them, or an earlier study</source>
   <translation>Viele Läufe, mehrere gleichzeitig: die einer Studiendatei oder die Hüllen und Abstandsprüfungen des Dokuments. Wählen Sie einige davon oder eine frühere Studie</translation>
  </message>
  <message>
   <source>Keyboard to the tree or panel</source>
   <translation>Tastatur zum Baum oder Panel</translation>
  </message>
  <message>
   <source>Puts the keyboard into the tree: arrows choose, Ctrl with arrows and Space chooses more; from the tree it goes to the open panel</source>
   <translation>Setzt die Tastatur in den Baum: Pfeile wählen, Strg mit Pfeilen und Leertaste wählt weitere; vom Baum geht sie zum offenen Panel</translation>
  </message>
  <message>
   <source>Improve path</source>
   <translation>Weg verbessern</translation>
  </message>
  <message>
   <source>Find path</source>
   <translation>Weg finden</translation>
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
   <source>The mesh has points that are no numbers: repair or export it.</source>
   <translation>Das Netz hat Punkte, die keine Zahlen sind: Reparieren Sie es oder exportieren Sie es neu.</translation>
  </message>
  <message>
   <source>The part encloses no volume: choose a solid or a closed mesh.</source>
   <translation>Das Teil umschließt keinen Raum: Wählen Sie einen Festkörper oder ein geschlossenes Netz.</translation>
  </message>
  <message>
   <source>The part is open, and its motion does not close it: close its holes, or check where the outside leaks in.</source>
   <translation>Das Teil ist offen, und seine Bewegung schließt es nicht: Schließen Sie seine Löcher, oder sehen Sie nach, wo es offen ist.</translation>
  </message>
  <message>
   <source>The part is too far from the origin for its size: move it nearer.</source>
   <translation>Das Teil liegt für seine Größe zu weit vom Ursprung: Rücken Sie es näher.</translation>
  </message>
  <message>
   <source>The part or the motion is too large: check the unit of length.</source>
   <translation>Das Teil oder die Bewegung ist zu groß: Prüfen Sie die Längeneinheit.</translation>
  </message>
  <message>
   <source>The cell is too large for the part: take a smaller one.</source>
   <translation>Die Zelle ist für das Teil zu groß: Nehmen Sie eine kleinere.</translation>
  </message>
  <message>
   <source>A setting is outside what is allowed.</source>
   <translation>Eine Einstellung liegt außerhalb des Erlaubten.</translation>
  </message>
  <message>
   <source>The motion has no poses: give at least one.</source>
   <translation>Die Bewegung hat keine Lagen: Geben Sie mindestens eine an.</translation>
  </message>
  <message>
   <source>A pose scales, shears or mirrors the part: give turns and shifts only.</source>
   <translation>Eine Lage skaliert, schert oder spiegelt das Teil: Erlaubt sind nur Drehungen und Verschiebungen.</translation>
  </message>
  <message>
   <source>A pose or its time cannot be used: times may not go back.</source>
   <translation>Eine Lage oder ihre Zeit ist unbrauchbar: Die Zeiten dürfen nicht zurückgehen.</translation>
  </message>
  <message>
   <source>Between two poses the part makes half a turn: put a pose between them.</source>
   <translation>Zwischen zwei Lagen dreht sich das Teil um 180 Grad: Setzen Sie eine Lage dazwischen.</translation>
  </message>
  <message>
   <source>Two parts lie in each other where they belong: move one, or ignore the pair.</source>
   <translation>Zwei Teile liegen ineinander, wo sie hingehören: verschieben Sie eines, oder lassen Sie das Paar aus.</translation>
  </message>
  <message>
   <source>Two parts are nearer where they belong than is asked for: ask for less, or allow contact there.</source>
   <translation>Zwei Teile sind dort, wo sie hingehören, näher als verlangt: verlangen Sie weniger, oder erlauben Sie dort Kontakt.</translation>
  </message>
  <message>
   <source>The file cannot be read as it stands.</source>
   <translation>Die Datei lässt sich so nicht lesen.</translation>
  </message>
  <message>
   <source>The ending of the file's name is not one that is known here.</source>
   <translation>Die Endung des Dateinamens ist hier nicht bekannt.</translation>
  </message>
  <message>
   <source>The file is larger than may be read.</source>
   <translation>Die Datei ist größer, als gelesen werden darf.</translation>
  </message>
  <message>
   <source>This would take more than it may: take a larger cell, or raise the memory limit.</source>
   <translation>Das bräuchte mehr, als erlaubt ist: Nehmen Sie eine größere Zelle, oder erhöhen Sie die Speichergrenze.</translation>
  </message>
  <message>
   <source>There are too many triangles: take a larger cell.</source>
   <translation>Es sind zu viele Dreiecke: Nehmen Sie eine größere Zelle.</translation>
  </message>
  <message>
   <source>The solid would have too many faces: give a tolerance, or keep the mesh.</source>
   <translation>Der Festkörper hätte zu viele Flächen: Geben Sie eine Toleranz an, oder bleiben Sie beim Netz.</translation>
  </message>
  <message>
   <source>The memory was not enough: take a larger cell.</source>
   <translation>Der Speicher hat nicht gereicht: Nehmen Sie eine größere Zelle.</translation>
  </message>
  <message>
   <source>Cancelled.</source>
   <translation>Abgebrochen.</translation>
  </message>
  <message>
   <source>There is no neighbour to be checked against.</source>
   <translation>Es gibt kein Nachbarteil, gegen das geprüft werden könnte.</translation>
  </message>
  <message>
   <source>A rule for a neighbour cannot be used: correct or remove it.</source>
   <translation>Eine Regel für ein Nachbarteil ist nicht verwendbar: berichtigen oder entfernen.</translation>
  </message>
  <message>
   <source>The template for reports has a placeholder that is not known: correct the template.</source>
   <translation>Die Vorlage für Berichte enthält einen unbekannten Platzhalter: Vorlage berichtigen.</translation>
  </message>
  <message>
   <source>The part does not fit where it belongs: a neighbour is in the way.</source>
   <translation>Das Teil passt nicht an seinen Platz: ein Nachbar ist im Weg.</translation>
  </message>
  <message>
   <source>The part does not fit where it comes from.</source>
   <translation>Das Teil passt nicht dorthin, woher es kommt.</translation>
  </message>
  <message>
   <source>The part does not fit at a place that it has to pass.</source>
   <translation>Das Teil passt nicht an eine Stelle, die es passieren muss.</translation>
  </message>
  <message>
   <source>The part is where it belongs already.</source>
   <translation>Das Teil ist schon an seinem Platz.</translation>
  </message>
  <message>
   <source>It is not said where the part comes from.</source>
   <translation>Es ist nicht gesagt, woher das Teil kommt.</translation>
  </message>
  <message>
   <source>The file could not be written: check folder and free space.</source>
   <translation>Die Datei konnte nicht geschrieben werden: Prüfen Sie Ordner und freien Platz.</translation>
  </message>
  <message>
   <source>The kernel for solids failed: give a tolerance, or a mesh file.</source>
   <translation>Der Kern für Festkörper hat versagt: Geben Sie eine Toleranz an, oder schreiben Sie eine Netzdatei.</translation>
  </message>
  <message>
   <source>There is no graphics device that can be used: choose the backend CPU.</source>
   <translation>Es gibt keine brauchbare Grafikkarte: Wählen Sie als Rechenwerk CPU.</translation>
  </message>
  <message>
   <source>The graphics device failed: choose the backend CPU.</source>
   <translation>Die Grafikkarte hat versagt: Wählen Sie als Rechenwerk CPU.</translation>
  </message>
  <message>
   <source>A part lies in itself: give each of its solids by itself, or join them first.</source>
   <translation>Ein Teil liegt in sich selbst: jeden seiner Festkörper einzeln angeben oder sie vorher vereinigen.</translation>
  </message>
  <message>
   <source>It cannot be told what two of the parts share.</source>
   <translation>Was zwei der Teile gemeinsam haben, lässt sich nicht sagen.</translation>
  </message>
  <message>
   <source>The part is open; its motion closes it.</source>
   <translation>Das Teil ist offen; seine Bewegung schließt es.</translation>
  </message>
  <message>
   <source>Triangles without an area were left out.</source>
   <translation>Dreiecke ohne Fläche wurden weggelassen.</translation>
  </message>
  <message>
   <source>Triangles that repeat others were left out.</source>
   <translation>Doppelte Dreiecke wurden weggelassen.</translation>
  </message>
  <message>
   <source>Triangles back to back were left out.</source>
   <translation>Dreiecke Rücken an Rücken wurden weggelassen.</translation>
  </message>
  <message>
   <source>How deep an allowed contact goes is not proven.</source>
   <translation>Wie tief ein erlaubter Kontakt reicht, ist nicht bewiesen.</translation>
  </message>
  <message>
   <source>Poses have the time of the one before; their order was kept.</source>
   <translation>Lagen haben die Zeit der vorigen; ihre Reihenfolge wurde beibehalten.</translation>
  </message>
  <message>
   <source>The part was inside out and was turned over.</source>
   <translation>Das Innere des Teils war außen; es wurde umgestülpt.</translation>
  </message>
  <message>
   <source>Triangles of the part face different ways.</source>
   <translation>Dreiecke des Teils sind verschieden ausgerichtet.</translation>
  </message>
  <message>
   <source>The surface of the part has one side only.</source>
   <translation>Die Oberfläche des Teils hat nur eine Seite.</translation>
  </message>
  <message>
   <source>More than two triangles meet at edges of the part.</source>
   <translation>An Kanten des Teils treffen sich mehr als zwei Dreiecke.</translation>
  </message>
  <message>
   <source>The part crosses itself and is inside out in places.</source>
   <translation>Das Teil durchdringt sich selbst, und stellenweise ist sein Inneres außen.</translation>
  </message>
  <message>
   <source>The part has hollow spaces inside.</source>
   <translation>Das Teil hat innen Hohlräume.</translation>
  </message>
  <message>
   <source>The part has bodies inside others; they count as material.</source>
   <translation>Im Teil liegen Körper in anderen; sie zählen als Material.</translation>
  </message>
  <message>
   <source>Poses that repeat the one before were left out.</source>
   <translation>Lagen, die die vorige wiederholen, wurden weggelassen.</translation>
  </message>
  <message>
   <source>Poses that were not quite rigid were mended.</source>
   <translation>Nicht ganz starre Lagen wurden berichtigt.</translation>
  </message>
  <message>
   <source>Hollow spaces inside the envelope were filled.</source>
   <translation>Hohlräume in der Hülle wurden gefüllt.</translation>
  </message>
  <message>
   <source>Triangles of the envelope cross each other.</source>
   <translation>Dreiecke der Hülle durchdringen sich.</translation>
  </message>
  <message>
   <source>The envelope was not simplified.</source>
   <translation>Die Hülle wurde nicht vereinfacht.</translation>
  </message>
  <message>
   <source>The envelope was simplified less than the tolerance allows.</source>
   <translation>Die Hülle wurde weniger vereinfacht, als die Toleranz erlaubt.</translation>
  </message>
  <message>
   <source>It was not checked whether triangles cross each other.</source>
   <translation>Ob sich Dreiecke durchdringen, wurde nicht geprüft.</translation>
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
   <source>Select the part whose way is to be found.</source>
   <translation>Wählen Sie das Teil, dessen Weg gefunden werden soll.</translation>
  </message>
  <message>
   <source>Select the part that moves together with the motion.</source>
   <translation>Wählen Sie das Teil, das sich bewegt, zusammen mit der Bewegung.</translation>
  </message>
  <message>
   <source>"{0}" has less than two keys: there is no way.</source>
   <translation>"{0}" hat weniger als zwei Schlüssel: es gibt keinen Weg.</translation>
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
   <translation>Wählen Sie mindestens zwei Objekte aus, deren Platzierungen die Stellungen sind.</translation>
  </message>
  <message>
   <source>Select at least two objects whose placements are the poses, in the order of the motion: copies or links of the part, or local coordinate systems.</source>
   <translation>Mindestens zwei Objekte auswählen, deren Platzierungen die Lagen sind, in der Reihenfolge der Bewegung: Kopien oder Verknüpfungen des Teils oder lokale Koordinatensysteme.</translation>
  </message>
  <message>
   <source>Select a wire, sketch, array, path, trajectory, or a simulation and a part.</source>
   <translation>Wählen Sie einen Draht, eine Skizze, eine Anordnung, einen Pfad, eine Bahn oder eine Simulation und ein Teil aus.</translation>
  </message>
  <message>
   <source>Select one wire, sketch, robot trajectory, link or Draft array, or CAM path; or a path and a second curve; or a simulation of an assembly and the part to watch.</source>
   <translation>Einen Linienzug, eine Skizze, eine Roboterbahn, eine Link- oder Draft-Anordnung oder einen CAM-Pfad wählen; oder einen Weg und eine zweite Kurve; oder eine Simulation einer Baugruppe und das zu verfolgende Teil.</translation>
  </message>
  <message>
   <source>No envelope is stale. Select one to compute it again.</source>
   <translation>Keine Hülle ist veraltet. Eine auswählen, um sie neu zu berechnen.</translation>
  </message>
  <message>
   <source>no moving part is given: choose a solid or a mesh that moves.</source>
   <translation>Es ist kein bewegtes Teil angegeben: einen Festkörper oder ein Netz wählen, das sich bewegt.</translation>
  </message>
  <message>
   <source>the link "{0}" shows nothing: what it linked to was deleted, or its document is not open. Open that document, or link to something else.</source>
   <translation>Die Verknüpfung „{0}“ zeigt nichts: Ihr Ziel wurde gelöscht, oder dessen Dokument ist nicht geöffnet. Öffnen Sie dieses Dokument, oder verknüpfen Sie mit etwas anderem.</translation>
  </message>
  <message>
   <source>"{0}" holds neither a solid nor a mesh.</source>
   <translation>„{0}“ enthält weder Festkörper noch Netz.</translation>
  </message>
  <message>
   <source>the moving part is empty.</source>
   <translation>Das bewegte Teil ist leer.</translation>
  </message>
  <message>
   <source>the shape gave no triangles.</source>
   <translation>Die Form ergab keine Dreiecke.</translation>
  </message>
  <message>
   <source>the shape has no solid (faces: {0}). Sweep a solid or a closed mesh; Part &gt; Convert to solid or Part &gt; Shape builder close a shape.</source>
   <translation>Die Form hat keinen Festkörper (Flächen: {0}). Einen Festkörper oder ein geschlossenes Netz verwenden; Part &gt; In Festkörper umwandeln oder der Formgenerator schließen eine Form.</translation>
  </message>
  <message>
   <source>"{0}" no longer leads to an object; choose the part again.</source>
   <translation>„{0}“ führt zu keinem Objekt mehr; das Teil neu wählen.</translation>
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
   <source>Too near</source>
   <translation>Zu nah</translation>
  </message>
  <message>
   <source>Contact</source>
   <translation>Berührung</translation>
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
   <source>the rules ignore every neighbour: leave at least one to be checked.</source>
   <translation>die Regeln übergehen jeden Nachbarn: lassen Sie mindestens einen prüfen.</translation>
  </message>
  <message>
   <source>{0} moved as well when this motion was read, and stand still in this check: use Check mechanism for parts that move at the same time.</source>
   <translation>{0} bewegten sich mit, als diese Bewegung gelesen wurde, und stehen in dieser Prüfung still: für Teile, die sich gleichzeitig bewegen, Mechanismus prüfen verwenden.</translation>
  </message>
  <message>
   <source>"{0}" is no envelope: choose another one.</source>
   <translation>„{0}“ ist keine Hülle: anderes Objekt wählen.</translation>
  </message>
  <message>
   <source>the parts of "{0}" have motions of their own: check each part with its motion.</source>
   <translation>die Teile von „{0}“ haben eigene Bewegungen: jedes Teil mit seiner Bewegung prüfen.</translation>
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
   <translation>{0} durchdringen sich</translation>
  </message>
  <message>
   <source>{0} in contact</source>
   <translation>{0} berühren sich</translation>
  </message>
  <message>
   <source>{0} too near</source>
   <translation>{0} zu nah</translation>
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
   <translation>tiefste Durchdringung {0} bei t = {1} s ({2})</translation>
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
   <source>cavities cannot be kept where parts have motions of their own: make one envelope for each motion.</source>
   <translation>Hohlräume können nicht erhalten bleiben, wenn Teile eigene Bewegungen haben: für jede Bewegung eine eigene Hülle anlegen.</translation>
  </message>
  <message>
   <source>{0} moving parts and {1} motions of their own: give one for each part, or none.</source>
   <translation>{0} bewegte Teile und {1} eigene Bewegungen: für jedes Teil eine angeben oder keine.</translation>
  </message>
  <message>
   <source>the core was built without OpenCASCADE: FreeCAD made a face of every triangle, and no surfaces were looked for</source>
   <translation>der Rechenkern wurde ohne OpenCASCADE gebaut: FreeCAD hat aus jedem Dreieck eine Fläche gemacht; nach gekrümmten Flächen wurde nicht gesucht</translation>
  </message>
  <message>
   <source>FreeCAD's own way gives no valid solid of this envelope; build the core with OpenCASCADE, or export a mesh file.</source>
   <translation>FreeCADs eigener Weg ergibt keinen gültigen Festkörper aus dieser Hülle: den Rechenkern mit OpenCASCADE bauen oder eine Netzdatei exportieren.</translation>
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
   <source>no neighbour is given: choose parts or show some others.</source>
   <translation>Es ist kein Nachbar angegeben: Teile wählen oder andere einblenden.</translation>
  </message>
  <message>
   <source>"{0}" only stands at its poses: choose what it does between them first.</source>
   <translation>"{0}" steht nur an ihren Posen: wählen Sie zuerst, was sie dazwischen tut.</translation>
  </message>
  <message>
   <source>"{0}" moves no visible part: show the parts, or choose another source.</source>
   <translation>„{0}“ bewegt kein sichtbares Teil: die Teile zeigen oder eine andere Quelle wählen.</translation>
  </message>
  <message>
   <source>"{0}" is left out: it is seen through a link, and no motion can name it. Make its parts members of the assembly.</source>
   <translation>„{0}“ wird ausgelassen: Es ist nur durch eine Verknüpfung zu sehen, und keine Bewegung kann es benennen. Seine Teile zu Mitgliedern der Baugruppe machen.</translation>
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
   <source>{0} moving parts and {1} motions: give one motion for each part.</source>
   <translation>{0} bewegte Teile und {1} Bewegungen: für jedes Teil eine Bewegung angeben.</translation>
  </message>
  <message>
   <source>there is no common time: "{0}" ends at {1} s, and "{2}" begins at {3} s.</source>
   <translation>Es gibt keine gemeinsame Zeit: „{0}“ endet bei {1} s, und „{2}“ beginnt bei {3} s.</translation>
  </message>
  <message>
   <source>the document was changed while its parts were read: start again.</source>
   <translation>das Dokument wurde geändert, während seine Teile gelesen wurden: noch einmal starten.</translation>
  </message>
  <message>
   <source>"{0}" has no motion: choose one for it.</source>
   <translation>„{0}“ hat keine Bewegung: eine wählen.</translation>
  </message>
  <message>
   <source>"{0}" is there twice: give each part one motion.</source>
   <translation>„{0}“ ist zweimal da: jedem Teil eine Bewegung geben.</translation>
  </message>
  <message>
   <source>"{0}" and "{1}": one holds the other, so that it would move twice. Take one of them away.</source>
   <translation>„{0}“ und „{1}“: Eines enthält das andere, das sich so zweimal bewegen würde. Eines von beiden wegnehmen.</translation>
  </message>
  <message>
   <source>"{0}" only jumps from pose to pose: parts that move at the same time need a motion between them. Choose another interpolation.</source>
   <translation>„{0}“ springt nur von Lage zu Lage: Teile, die sich gleichzeitig bewegen, brauchen eine Bewegung dazwischen. Eine andere Interpolation wählen.</translation>
  </message>
  <message>
   <source>one part alone has no distance: add a second one that moves or stands still.</source>
   <translation>Ein Teil allein hat keinen Abstand: ein zweites hinzufügen, das sich bewegt oder stillsteht.</translation>
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
   <source>{0} was deleted, and {1} is not whole without it: choose anew what is to be used ({2}), or undo the deletion.</source>
   <translation>{0} wurde gelöscht, und {1} ist ohne das nicht vollständig: wählen Sie neu, was verwendet werden soll ({2}), oder machen Sie das Löschen rückgängig.</translation>
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
   <source>the frames of "{0}" lie far apart: near {1} s the part may leave its way between two of them by about {2}. Read the motion with smaller steps.</source>
   <translation>die Bilder von "{0}" liegen weit auseinander: bei {1} s kann das Teil seinen Weg zwischen zweien um etwa {2} verlassen. Lesen Sie die Bewegung mit kleineren Schritten.</translation>
  </message>
  <message>
   <source>no motion is given: make one with New motion and choose it.</source>
   <translation>Es ist keine Bewegung angegeben: mit Neue Bewegung eine erzeugen und wählen.</translation>
  </message>
  <message>
   <source>a reference part is given, but no motion of it: choose its motion, or take the reference part away.</source>
   <translation>ein Bezugsteil ist gegeben, aber keine Bewegung dafür: wählen Sie seine Bewegung, oder nehmen Sie das Bezugsteil heraus.</translation>
  </message>
  <message>
   <source>a motion of the reference is given, but no reference part: choose it as well.</source>
   <translation>eine Bewegung des Bezugs ist angegeben, aber kein Bezugsteil: auch dieses wählen.</translation>
  </message>
  <message>
   <source>"{0}" is no motion: choose another one.</source>
   <translation>„{0}“ ist keine Bewegung: anderes Objekt wählen.</translation>
  </message>
  <message>
   <source>two rules contradict each other for "{0}": keep one.</source>
   <translation>zwei Regeln für "{0}" widersprechen einander: behalten Sie eine.</translation>
  </message>
  <message>
   <source>"{0}": there is no rule "{1}".</source>
   <translation>"{0}": eine Regel "{1}" gibt es nicht.</translation>
  </message>
  <message>
   <source>"{0}": a length of {1} mm is not possible in a rule.</source>
   <translation>"{0}": eine Länge von {1} mm ist in einer Regel nicht möglich.</translation>
  </message>
  <message>
   <source>the rules of "{0}" do not fit its parts ({1} parts, {2} kinds, {3} lengths): give them anew.</source>
   <translation>die Regeln von "{0}" passen nicht zu seinen Teilen ({1} Teile, {2} Arten, {3} Längen): geben Sie sie neu an.</translation>
  </message>
  <message>
   <source>choose two or more parts, envelopes or solids to compare.</source>
   <translation>zwei oder mehr Teile, Hüllen oder Festkörper zum Vergleichen wählen.</translation>
  </message>
  <message>
   <source>"{0}" holds "{1}": take one of them away.</source>
   <translation>„{0}“ enthält „{1}“: eines von beiden wegnehmen.</translation>
  </message>
  <message>
   <source>the rules for "{0}" and for "{1}" contradict each other for "{2}", and none of them is the narrower one: give this pair a rule of its own.</source>
   <translation>die Regeln für "{0}" und für "{1}" widersprechen sich für "{2}", und keine von ihnen ist die engere: Geben Sie diesem Paar eine eigene Regel.</translation>
  </message>
  <message>
   <source>the rules of "{0}" do not fit its parts ({1} parts, two for each rule, {2} kinds, {3} lengths): give them anew.</source>
   <translation>Die Regeln von „{0}“ passen nicht zu den Teilen ({1} Teile, zwei für jede Regel, {2} Arten, {3} Längen): neu angeben.</translation>
  </message>
  <message>
   <source>Path of {0}</source>
   <translation>Weg von {0}</translation>
  </message>
  <message>
   <source>give a start, or how far the part is to get out.</source>
   <translation>geben Sie einen Start an, oder wie weit das Teil hinaus soll.</translation>
  </message>
  <message>
   <source>Check sequence</source>
   <translation>Einbaufolge prüfen</translation>
  </message>
  <message>
   <source>{0} of {1} parts have a path</source>
   <translation>{0} von {1} Teilen haben einen Weg</translation>
  </message>
  <message>
   <source>clearance at least {0}</source>
   <translation>Abstand mindestens {0}</translation>
  </message>
  <message>
   <source>proven: no way without turning</source>
   <translation>bewiesen: kein Weg ohne Drehung</translation>
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
   <source>no way; came {0}, in the way: {1}</source>
   <translation>kein Weg; kam {0} weit, im Weg: {1}</translation>
  </message>
  <message>
   <source>No order exists in which one part comes after the other: proven.</source>
   <translation>Es gibt keine Reihenfolge, in der ein Teil nach dem anderen kommt: bewiesen.</translation>
  </message>
  <message>
   <source>{0}, clearance {1}</source>
   <translation>{0}, Abstand {1}</translation>
  </message>
  <message>
   <source>{0}, nothing in the way</source>
   <translation>{0}, nichts im Weg</translation>
  </message>
  <message>
   <source>{0} parts and {1} motions: give one motion for each part.</source>
   <translation>{0} Teile und {1} Bewegungen: geben Sie für jedes Teil eine Bewegung an.</translation>
  </message>
  <message>
   <source>no part is given: select the parts, then press Add selected.</source>
   <translation>kein Teil ist angegeben: wählen Sie die Teile und drücken Sie Gewählte hinzufügen.</translation>
  </message>
  <message>
   <source>"{0}" only jumps from pose to pose: choose another interpolation, or let the way be found.</source>
   <translation>„{0}“ springt nur von Lage zu Lage: wählen Sie eine andere Interpolation oder lassen Sie den Weg finden.</translation>
  </message>
  <message>
   <source>They share no space; the smallest distance is {0}.</source>
   <translation>Sie haben keinen Raum gemeinsam; der kleinste Abstand ist {0}.</translation>
  </message>
  <message>
   <source>Shared volume</source>
   <translation>Gemeinsames Volumen</translation>
  </message>
  <message>
   <source>two sides are needed: choose two parts or envelopes.</source>
   <translation>es braucht zwei Seiten: zwei Teile oder Hüllen wählen.</translation>
  </message>
  <message>
   <source>"{0}" is on both sides: it shares all of itself with itself.</source>
   <translation>„{0}“ steht auf beiden Seiten: mit sich selbst hat es alles gemeinsam.</translation>
  </message>
  <message>
   <source>Make solid</source>
   <translation>Festkörper erzeugen</translation>
  </message>
  <message>
   <source>compute the envelope first: there is no mesh to make a solid of.</source>
   <translation>Zuerst die Hülle berechnen: Es gibt noch kein Netz für einen Festkörper.</translation>
  </message>
  <message>
   <source>the largest tolerance of an edge is {0}, more than the {1} by which the solid leaves the mesh: its faces meet no nearer there. A smaller Tolerance gives more faces that fit better.</source>
   <translation>die größte Toleranz einer Kante ist {0}, mehr als die {1}, um die der Festkörper das Netz verlässt: näher treffen sich seine Flächen dort nicht. Eine kleinere Toleranz gibt mehr Flächen, die besser passen.</translation>
  </message>
  <message>
   <source>the envelope is conservative, and a solid with a tolerance could cut into the swept volume: set the solid's Tolerance to 0.</source>
   <translation>die Hülle ist konservativ, und ein Festkörper mit Toleranz könnte in das überstrichene Volumen schneiden: Tolerance des Festkörpers auf 0 setzen.</translation>
  </message>
  <message>
   <source>{0} solid</source>
   <translation>{0} Festkörper</translation>
  </message>
  <message>
   <source>large parts are being read to see whether they have changed.</source>
   <translation>große Teile werden gelesen, um zu sehen, ob sie sich geändert haben.</translation>
  </message>
  <message>
   <source>Left out: {0}</source>
   <translation>Ausgelassen: {0}</translation>
  </message>
  <message>
   <source>Left out: {0} (envelopes and their solids are checked where they are chosen as neighbours).</source>
   <translation>Ausgelassen: {0} (Hüllen und ihre Volumenkörper werden geprüft, wenn sie als Nachbarn gewählt sind).</translation>
  </message>
  <message>
   <source>"{0}" is chosen as a neighbour and is a moving part itself: choose another one.</source>
   <translation>"{0}" ist als Nachbar gewählt und selbst ein bewegtes Teil: wählen Sie ein anderes.</translation>
  </message>
  <message>
   <source>{0} of {1} runs are left: run the study again to go on.</source>
   <translation>{0} von {1} Läufen sind übrig: Starten Sie die Studie erneut, um fortzufahren.</translation>
  </message>
  <message>
   <source>the results of the study are not there any more: run it again.</source>
   <translation>die Ergebnisse der Studie sind nicht mehr da: Rechnen Sie sie erneut.</translation>
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
   <source>"{0}" has no result that is up to date: run the study again first.</source>
   <translation>„{0}“ hat kein aktuelles Ergebnis: Lassen Sie die Studie zuerst noch einmal laufen.</translation>
  </message>
  <message>
   <source>the parts of "{0}" have motions of their own: a run of a study has one motion.</source>
   <translation>die Teile von "{0}" haben eigene Bewegungen: Ein Lauf einer Studie hat eine Bewegung.</translation>
  </message>
  <message>
   <source>"{0}": a study knows only consistent components (property Components).</source>
   <translation>"{0}": Eine Studie kennt nur konsistente Komponenten (Eigenschaft Components).</translation>
  </message>
  <message>
   <source>the study file has no run "{0}" any more: run the study again.</source>
   <translation>die Studiendatei hat keinen Lauf "{0}" mehr: Rechnen Sie die Studie erneut.</translation>
  </message>
  <message>
   <source>Run {0}</source>
   <translation>Lauf {0}</translation>
  </message>
  <message>
   <source>"{0}" cannot be a run of a study: choose envelopes and clearance checks of one motion.</source>
   <translation>"{0}" kann kein Lauf einer Studie sein: Wählen Sie Hüllen und Abstandsprüfungen mit einer Bewegung.</translation>
  </message>
  <message>
   <source>no runs are given: choose a study file, or envelopes and clearance checks.</source>
   <translation>keine Läufe angegeben: Wählen Sie eine Studiendatei oder Hüllen und Abstandsprüfungen.</translation>
  </message>
  <message>
   <source>save the document first, or choose a folder.</source>
   <translation>speichern Sie zuerst das Dokument oder wählen Sie einen Ordner.</translation>
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
   <source>the template "{0}" of the preferences is empty.</source>
   <translation>die Vorlage „{0}“ der Einstellungen ist leer.</translation>
  </message>
  <message>
   <source>changed since it was saved</source>
   <translation>seit dem Speichern geändert</translation>
  </message>
  <message>
   <source>"{0}" has no result that is up to date: recompute its envelope, if it has one, and check again first.</source>
   <translation>„{0}“ hat kein aktuelles Ergebnis: Berechnen Sie seine Hülle neu, wenn es eine hat, und prüfen Sie erneut.</translation>
  </message>
  <message>
   <source>SOURCE_DATE_EPOCH is "{0}"; it must be seconds since 1970.</source>
   <translation>SOURCE_DATE_EPOCH ist „{0}“; es müssen Sekunden seit 1970 sein.</translation>
  </message>
  <message>
   <source>the template "{0}" of the preferences cannot be read: {1}</source>
   <translation>die Vorlage „{0}“ der Einstellungen kann nicht gelesen werden: {1}</translation>
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
   <source>a PDF is written by the window alone.</source>
   <translation>ein PDF schreibt nur das Fenster.</translation>
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
   <source>parts that are seen from another one have no place in the document.</source>
   <translation>Teile, die von einem anderen aus gesehen werden, haben keinen Ort im Dokument.</translation>
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
   <source>{0}: "{1}" is not understood here; it counts as {2}.</source>
   <translation>{0}: „{1}“ wird hier nicht verstanden; es zählt als {2}.</translation>
  </message>
  <message>
   <source>what made an envelope is known of the swept volume itself: this one has an offset or is conservative.</source>
   <translation>was eine Hülle erzeugt hat, ist nur vom überstrichenen Volumen selbst bekannt: Diese hat einen Sicherheitsabstand oder ist konservativ.</translation>
  </message>
  <message>
   <source>Transform is locked while the path editor is open: drag the chosen key, or type numbers.</source>
   <translation>Transformieren ist gesperrt, solange der Pfad-Editor offen ist: Ziehen Sie die gewählte Stützstelle, oder geben Sie Zahlen ein.</translation>
  </message>
  <message>
   <source>there is no change of the keys to undo or redo.</source>
   <translation>Es gibt keine Änderung der Stützstellen, die rückgängig gemacht oder wiederholt werden kann.</translation>
  </message>
  <message>
   <source>no part: close the panel, select the moving part and open it again.</source>
   <translation>Kein Teil: das Fenster schließen, das bewegte Teil auswählen und neu öffnen.</translation>
  </message>
  <message>
   <source>only Absolute poses can be captured.</source>
   <translation>Nur absolute Lagen können übernommen werden.</translation>
  </message>
  <message>
   <source>choose a key in the table first.</source>
   <translation>Zuerst einen Schlüssel in der Tabelle wählen.</translation>
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
   <source>"{0}" does not know its part: add the part, then choose it.</source>
   <translation>„{0}“ kennt sein Teil nicht: das Teil hinzufügen und dann die Bewegung wählen.</translation>
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
   <source>The part came {0} away from where it belongs; it is shown there.</source>
   <translation>Das Teil kam {0} von seinem Platz weg; dort wird es gezeigt.</translation>
  </message>
  <message>
   <source>Most often in the way: {0}.</source>
   <translation>Am häufigsten im Weg: {0}.</translation>
  </message>
  <message>
   <source>A path was found with a clearance of {0}: ask for less.</source>
   <translation>Mit einem Abstand von {0} wurde ein Weg gefunden: verlangen Sie weniger.</translation>
  </message>
  <message>
   <source>{0} keys instead of {1}, {2} instead of {3}, clearance {4} instead of {5}.</source>
   <translation>{0} Schlüssel statt {1}, {2} statt {3}, Abstand {4} statt {5}.</translation>
  </message>
  <message>
   <source>There is no path on which the part never turns: proven.</source>
   <translation>Es gibt keinen Weg, auf dem sich das Teil nie dreht: bewiesen.</translation>
  </message>
  <message>
   <source>Nothing of the motion keeps the clearance: ask for less, or find a path.</source>
   <translation>Nichts von der Bewegung hält den Abstand: verlangen Sie weniger, oder suchen Sie einen Weg.</translation>
  </message>
  <message>
   <source>Moves that stay nearer than asked for, as no other way was found there: {0}.</source>
   <translation>Züge, die näher bleiben als verlangt, da dort kein anderer Weg gefunden wurde: {0}.</translation>
  </message>
  <message>
   <source>Moves at the ends that are nearer, as allowed, and stay as they were: {0}.</source>
   <translation>Züge an den Enden, die näher sind, wie erlaubt, und bleiben, wie sie waren: {0}.</translation>
  </message>
  <message>
   <source>Found: {0} keys, {1}, turns of {2} degrees, clearance at least {3}.</source>
   <translation>Gefunden: {0} Schlüssel, {1}, Drehungen von {2} Grad, Abstand mindestens {3}.</translation>
  </message>
  <message>
   <source>Nearer than that, as allowed, within {0} of the ends: {1}.</source>
   <translation>Näher als das, wie erlaubt, bis {0} von den Enden: {1}.</translation>
  </message>
  <message>
   <source>No path was found in this time.</source>
   <translation>In dieser Zeit wurde kein Weg gefunden.</translation>
  </message>
  <message>
   <source>No path was found.</source>
   <translation>Es wurde kein Weg gefunden.</translation>
  </message>
  <message>
   <source>A path was found without any clearance: ask for less.</source>
   <translation>Ganz ohne Abstand wurde ein Weg gefunden: verlangen Sie weniger.</translation>
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
   <source>"{0}": {1} numbers are needed here, with blanks between.</source>
   <translation>"{0}": hier braucht es {1} Zahlen mit Leerzeichen dazwischen.</translation>
  </message>
  <message>
   <source>a part of this row is there no more: check again.</source>
   <translation>ein Teil dieser Zeile ist nicht mehr da: neu prüfen.</translation>
  </message>
  <message>
   <source>"{0}": a clearance of {1} is not possible.</source>
   <translation>"{0}": ein Abstand von {1} ist nicht möglich.</translation>
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
   <source>no program was found that shows {0}.</source>
   <translation>kein Programm gefunden, das {0} zeigt.</translation>
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
   <source>Cancelled: the document or an object is gone.</source>
   <translation>Abgebrochen: Das Dokument oder ein Objekt ist weg.</translation>
  </message>
  <message>
   <source>there is no room in the temporary folder {0}: make room there, or set the environment variable TMPDIR to another folder.</source>
   <translation>im Ordner {0} für vorübergehende Dateien ist kein Platz mehr: dort Platz schaffen oder mit der Umgebungsvariablen TMPDIR einen anderen Ordner angeben.</translation>
  </message>
  <message>
   <source>studies need the Python package swept_volume beside the compiled core, and the folder {0} has none: install the workbench again, or build it with cmake --build build.</source>
   <translation>Studien brauchen das Python-Paket swept_volume neben dem übersetzten Kern, und im Ordner {0} ist keines: installieren Sie die Arbeitsumgebung neu oder bauen Sie sie mit cmake --build build.</translation>
  </message>
  <message>
   <source>the study ended with status {0} and no result.</source>
   <translation>die Studie endete mit Status {0} und ohne Ergebnis.</translation>
  </message>
  <message>
   <source>studies need the program {0}, and it was not found: install it.</source>
   <translation>Studien brauchen das Programm {0}, und es wurde nicht gefunden: installieren Sie es.</translation>
  </message>
  <message>
   <source>study files cannot be read: {0}</source>
   <translation>Studiendateien können nicht gelesen werden: {0}</translation>
  </message>
  <message>
   <source>the study file "{0}" cannot be read: {1}</source>
   <translation>die Studiendatei "{0}" kann nicht gelesen werden: {1}</translation>
  </message>
  <message>
   <source>the file type "{0}" is unknown; use one of {1}.</source>
   <translation>Der Dateityp „{0}“ ist unbekannt; möglich sind {1}.</translation>
  </message>
  <message>
   <source>the folder "{0}" does not exist.</source>
   <translation>Der Ordner „{0}“ existiert nicht.</translation>
  </message>
  <message>
   <source>"{0}" is a folder.</source>
   <translation>„{0}“ ist ein Ordner.</translation>
  </message>
  <message>
   <source>"{0}" is write-protected.</source>
   <translation>„{0}“ ist schreibgeschützt.</translation>
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
   <source>choose a simulation of an assembly, then the part to watch.</source>
   <translation>eine Simulation einer Baugruppe wählen, dann das zu verfolgende Teil.</translation>
  </message>
  <message>
   <source>the simulation "{0}" stopped early: {1} of {2} frames, the last at {3} s of {4} s. Its solver found no position there: look at its joints and formulas, or let it end sooner.</source>
   <translation>die Simulation "{0}" endete vorzeitig: {1} von {2} Bildern, das letzte bei {3} s von {4} s. Ihr Löser fand dort keine Lage: sehen Sie nach ihren Gelenken und Formeln, oder lassen Sie sie früher enden.</translation>
  </message>
  <message>
   <source>"{0}" belongs to no assembly that this FreeCAD can run: simulations need FreeCAD 1.1.</source>
   <translation>„{0}“ gehört zu keiner Baugruppe, die dieses FreeCAD bewegen kann: Simulationen brauchen FreeCAD 1.1.</translation>
  </message>
  <message>
   <source>choose one CAM (Path) object.</source>
   <translation>Ein CAM-Objekt (Path) wählen.</translation>
  </message>
  <message>
   <source>"{0}" has no moves (G0 to G3).</source>
   <translation>„{0}“ hat keine Bewegungen (G0 bis G3).</translation>
  </message>
  <message>
   <source>the motion file "{0}" does not exist; choose another.</source>
   <translation>Die Bewegungsdatei „{0}“ existiert nicht; eine andere wählen.</translation>
  </message>
  <message>
   <source>a path needs at least two poses.</source>
   <translation>Eine Bahn braucht mindestens zwei Lagen.</translation>
  </message>
  <message>
   <source>choose two wires: the path, then the curve that orients.</source>
   <translation>zwei Linienzüge wählen: den Weg, dann die Kurve, die ausrichtet.</translation>
  </message>
  <message>
   <source>choose one wire, edge or sketch as the path.</source>
   <translation>Einen Linienzug, eine Kante oder Skizze als Bahn wählen.</translation>
  </message>
  <message>
   <source>an accuracy of {0}: it must be greater than 0.</source>
   <translation>eine Genauigkeit von {0}: sie muss größer als 0 sein.</translation>
  </message>
  <message>
   <source>"{0}" has {1} separate pieces; a path must be one.</source>
   <translation>„{0}“ hat {1} getrennte Stücke; eine Bahn muss eines sein.</translation>
  </message>
  <message>
   <source>an accuracy of {0} takes more than {1} poses along this path: allow more.</source>
   <translation>eine Genauigkeit von {0} braucht auf diesem Weg mehr als {1} Posen: lassen Sie mehr zu.</translation>
  </message>
  <message>
   <source>"{0}" begins in the direction of the path "{1}": it does not say where up is. Move it sideways.</source>
   <translation>„{0}“ beginnt in Richtung des Weges „{1}“: sie sagt nicht, wo oben ist. Sie seitlich versetzen.</translation>
  </message>
  <message>
   <source>"{0}" = {1:g}: the document does not recompute.</source>
   <translation>„{0}“ = {1:g}: Das Dokument lässt sich nicht neu berechnen.</translation>
  </message>
  <message>
   <source>choose the object whose value is driven, then the part to watch.</source>
   <translation>das Objekt wählen, dessen Wert gesteuert wird, dann das zu verfolgende Teil.</translation>
  </message>
  <message>
   <source>"{0}" has no value "{1}" that can be driven; it has: {2}</source>
   <translation>„{0}“ hat keinen steuerbaren Wert „{1}“; vorhanden: {2}</translation>
  </message>
  <message>
   <source>"{0}" of "{1}" follows the expression {2}: drive what it reads.</source>
   <translation>„{0}“ von „{1}“ folgt dem Ausdruck {2}: steuern, was dieser liest.</translation>
  </message>
  <message>
   <source>the clipboard holds no rows of numbers.</source>
   <translation>Die Zwischenablage enthält keine Zeilen mit Zahlen.</translation>
  </message>
  <message>
   <source>there is a key at this time already.</source>
   <translation>zu dieser Zeit gibt es schon eine Stützstelle.</translation>
  </message>
  <message>
   <source>"{0}" is not a number or quantity in {1}.</source>
   <translation>„{0}“ ist keine Zahl oder Größe in {1}.</translation>
  </message>
  <message>
   <source>the time of key {0} must lie between those of its neighbours.</source>
   <translation>Die Zeit von Schlüssel {0} muss zwischen denen seiner Nachbarn liegen.</translation>
  </message>
  <message>
   <source>row {0} of what is pasted has {1} columns: give t, x, y, z, or these and yaw, pitch, roll.</source>
   <translation>Zeile {0} des Eingefügten hat {1} Spalten: Geben Sie t, x, y, z oder diese und Gieren, Nicken, Rollen an.</translation>
  </message>
  <message>
   <source>"{0}" gave no frames: does it run in its own panel?</source>
   <translation>„{0}“ ergab keine Bilder: läuft sie in ihrem eigenen Aufgabenbereich?</translation>
  </message>
  <message>
   <source>choose at least one object with a placement.</source>
   <translation>Mindestens ein Objekt mit einer Platzierung wählen.</translation>
  </message>
  <message>
   <source>"{0}" has no placement and cannot be a pose.</source>
   <translation>„{0}“ hat keine Platzierung und kann keine Lage sein.</translation>
  </message>
  <message>
   <source>pose {0}: its time ({1:g}) is no moment.</source>
   <translation>Lage {0}: ihre Zeit ({1:g}) ist kein Zeitpunkt.</translation>
  </message>
  <message>
   <source>pose {0}: its time {1:g} s comes before the {2:g} s of the pose before; times may not go back.</source>
   <translation>Lage {0}: Ihre Zeit {1:g} s liegt vor den {2:g} s der Lage davor; Zeiten dürfen nicht zurückgehen.</translation>
  </message>
  <message>
   <source>the motion has no poses: add at least one.</source>
   <translation>Die Bewegung hat keine Lagen: mindestens eine hinzufügen.</translation>
  </message>
  <message>
   <source>the frame "{0}" is unknown; allowed: {1}.</source>
   <translation>Der Bezug „{0}“ ist unbekannt; möglich sind {1}.</translation>
  </message>
  <message>
   <source>the motion has {0} times and {1} placements.</source>
   <translation>Die Bewegung hat {0} Zeiten und {1} Platzierungen.</translation>
  </message>
  <message>
   <source>poses {0} and {1} have the same time ({2:g} s): a smooth motion, and one seen from a moving reference, need different ones.</source>
   <translation>Lagen {0} und {1} haben dieselbe Zeit ({2:g} s): Eine glatte Bewegung, und eine von einem bewegten Bezugsteil aus gesehene, brauchen verschiedene.</translation>
  </message>
  <message>
   <source>choose one Robot trajectory.</source>
   <translation>Eine Roboterbahn wählen.</translation>
  </message>
  <message>
   <source>"{0}" has {1} waypoints; a motion needs at least two.</source>
   <translation>„{0}“ hat {1} Wegpunkte; eine Bewegung braucht mindestens zwei.</translation>
  </message>
  <message>
   <source>the settings of the motion's source are damaged: choose the source again, or keep the poses as they are.</source>
   <translation>Die Einstellungen der Quelle dieser Bewegung sind beschädigt: die Quelle neu wählen oder die Lagen behalten, wie sie sind.</translation>
  </message>
  <message>
   <source>this motion keeps its own poses and has no source to read again.</source>
   <translation>Diese Bewegung hat eigene Lagen und keine Quelle, die neu gelesen werden könnte.</translation>
  </message>
  <message>
   <source>{0} poses: allowed are {1} to {2}.</source>
   <translation>{0} Lagen: erlaubt sind {1} bis {2}.</translation>
  </message>
  <message>
   <source>no smooth way leads from pose {0} to pose {1}: their times, placements or given velocities are beyond all measure.</source>
   <translation>Von Lage {0} zu Lage {1} führt kein glatter Weg: Zeiten, Platzierungen oder gegebene Geschwindigkeiten sind jenseits allen Maßes.</translation>
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
   <source>the face itself, at a key</source>
   <translation>die Fläche selbst, an einer Stützstelle</translation>
  </message>
  <message>
   <source>swept by an edge</source>
   <translation>von einer Kante überstrichen</translation>
  </message>
  <message>
   <source>swept by a face in passing</source>
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
   <source>at s</source>
   <translation>bei s</translation>
  </message>
  <message>
   <source>Between the meshes; the line above has taken off how far these may leave the parts</source>
   <translation>Zwischen den Netzen; in der Zeile darüber ist abgezogen, wie weit diese von den Teilen abweichen können</translation>
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
   <source>depth</source>
   <translation>Tiefe</translation>
  </message>
  <message>
   <source>{0} (stale: check again)</source>
   <translation>{0} (veraltet: neu prüfen)</translation>
  </message>
  <message>
   <source>Place &amp;before</source>
   <translation>Stelle &amp;davor</translation>
  </message>
  <message>
   <source>Back to the place that is worse than this one</source>
   <translation>Zurück zur Stelle, die schlimmer ist als diese</translation>
  </message>
  <message>
   <source>&amp;Next worst place</source>
   <translation>&amp;Nächstschlimmste Stelle</translation>
  </message>
  <message>
   <source>Goes through the places from the worst on: clashes, the deepest first, then what is nearest</source>
   <translation>Geht die Stellen von der schlimmsten an durch: Kollisionen, die tiefste zuerst, dann was am nächsten ist</translation>
  </message>
  <message>
   <source>Rule: {0}</source>
   <translation>Regel: {0}</translation>
  </message>
  <message>
   <source>Nothing touches at the first pose.</source>
   <translation>In der ersten Lage berührt sich nichts.</translation>
  </message>
  <message>
   <source>Contact allowed, where it is meant: {0}</source>
   <translation>Kontakt erlaubt, sofern er so gemeint ist: {0}</translation>
  </message>
  <message>
   <source>{0}: {1} {2} at {3} s</source>
   <translation>{0}: {1} {2} bei {3} s</translation>
  </message>
  <message>
   <source>No curve yet: check first.</source>
   <translation>Noch keine Kurve: zuerst prüfen.</translation>
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
   <source>All other visible parts</source>
   <translation>Alle anderen sichtbaren Teile</translation>
  </message>
  <message>
   <source>Ta&amp;ke selected as neighbours</source>
   <translation>Ausgewählte als &amp;Nachbarn</translation>
  </message>
  <message>
   <source>Required distance</source>
   <translation>Geforderter Abstand</translation>
  </message>
  <message>
   <source>Tolerance</source>
   <translation>Toleranz</translation>
  </message>
  <message>
   <source>Mesh deflection</source>
   <translation>Netzabweichung</translation>
  </message>
  <message>
   <source>length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <source>What the moving parts touch at the first pose of the motion may be touched at any time</source>
   <translation>Was die bewegten Teile in der ersten Lage der Bewegung berühren, darf jederzeit berührt werden</translation>
  </message>
  <message>
   <source>Allow what &amp;touches at first</source>
   <translation>&amp;Berührung am Anfang erlauben</translation>
  </message>
  <message>
   <source>Neighbour</source>
   <translation>Nachbar</translation>
  </message>
  <message>
   <source>Makes a body of what the envelope shares with the part of the row</source>
   <translation>Macht einen Körper aus dem, was die Hülle mit dem Teil der Zeile gemeinsam hat</translation>
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
   <translation>Berührung: bis</translation>
  </message>
  <message>
   <source>too near: up to</source>
   <translation>zu nah: bis</translation>
  </message>
  <message>
   <source>clear: beyond</source>
   <translation>frei: darüber</translation>
  </message>
  <message>
   <source>The envelope has changed since the check: check again.</source>
   <translation>Die Hülle hat sich seit der Prüfung geändert: neu prüfen.</translation>
  </message>
  <message>
   <source>Keep volume to be cut awa&amp;y</source>
   <translation>Wegzuschneidendes Volumen behal&amp;ten</translation>
  </message>
  <message>
   <source>Swept envelope</source>
   <translation>Bewegungshülle</translation>
  </message>
  <message>
   <source>Cells along the longest side of the sweep</source>
   <translation>Zellen entlang der längsten Seite des überstrichenen Raums</translation>
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
   <source>Accuracy</source>
   <translation>Genauigkeit</translation>
  </message>
  <message>
   <source>Left coarse and quick, right fine and slow</source>
   <translation>Links grob und schnell, rechts fein und langsam</translation>
  </message>
  <message>
   <source>Largest deviation by simplification; 0: none</source>
   <translation>Größte Abweichung durch Vereinfachung; 0: keine</translation>
  </message>
  <message>
   <source>Safety distance around the swept volume</source>
   <translation>Sicherheitsabstand um den überstrichenen Raum</translation>
  </message>
  <message>
   <source>Given by</source>
   <translation>Vorgabe</translation>
  </message>
  <message>
   <source>Cells</source>
   <translation>Zellen</translation>
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
   <source>Simplification</source>
   <translation>Vereinfachung</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Zugabe</translation>
  </message>
  <message>
   <source>Contain the sweep provably</source>
   <translation>Überstrichenen Raum nachweislich enthalten</translation>
  </message>
  <message>
   <source>Keep enclosed cavities</source>
   <translation>Eingeschlossene Hohlräume behalten</translation>
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
   <source>For recordings of very many poses: leaves out those that move no point farther than this from the last one kept; 0: uses all</source>
   <translation>Für Aufzeichnungen mit sehr vielen Lagen: lässt solche aus, die keinen Punkt weiter als dies von der letzten behaltenen bewegen; 0: verwendet alle</translation>
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
   <source>Remembers which face or edge of which part made each place, and when, for "What made this?"; in the document it takes room</source>
   <translation>Merkt sich, welche Fläche oder Kante welches Teils jede Stelle erzeugt hat und wann, für „Was hat das erzeugt?“; im Dokument braucht das Platz</translation>
  </message>
  <message>
   <source>What made it</source>
   <translation>Was sie erzeugt hat</translation>
  </message>
  <message>
   <source>The parts are being read ...</source>
   <translation>Die Teile werden gelesen ...</translation>
  </message>
  <message>
   <source>A position filter of {0} would leave out most poses and be much quicker.</source>
   <translation>Ein Positionsfilter von {0} würde die meisten Posen weglassen und wäre viel schneller.</translation>
  </message>
  <message>
   <source>The motion has one key: the parts do not move. Add another.</source>
   <translation>Die Bewegung hat nur eine Stützstelle: Die Teile bewegen sich nicht. Fügen Sie eine weitere hinzu.</translation>
  </message>
  <message>
   <source>Number of cells</source>
   <translation>Zellenzahl</translation>
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
   <source>{0} poses, {1} to {2} s, moving {3} x {4} x {5}</source>
   <translation>{0} Stellungen, {1} bis {2} s, Weg {3} x {4} x {5}</translation>
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
   <source>Unit of length</source>
   <translation>Längeneinheit</translation>
  </message>
  <message>
   <source>Between poses</source>
   <translation>Zwischen Lagen</translation>
  </message>
  <message>
   <source>A pose is</source>
   <translation>Eine Lage ist</translation>
  </message>
  <message>
   <source>&amp;Find path</source>
   <translation>Weg &amp;finden</translation>
  </message>
  <message>
   <source>Find path</source>
   <translation>Weg finden</translation>
  </message>
  <message>
   <source>Way of the part</source>
   <translation>Weg des Teils</translation>
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
   <source>It belongs</source>
   <translation>Es gehört</translation>
  </message>
  <message>
   <source>It comes from</source>
   <translation>Es kommt</translation>
  </message>
  <message>
   <source>The part never turns</source>
   <translation>Das Teil dreht sich nie</translation>
  </message>
  <message>
   <source>From how the part stands where it belongs; 180: as it likes</source>
   <translation>Gegenüber seiner Stellung an seinem Platz; 180: beliebig</translation>
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
   <translation>Weg ver&amp;bessern</translation>
  </message>
  <message>
   <source>Improve path</source>
   <translation>Weg verbessern</translation>
  </message>
  <message>
   <source>Key {0}, {1} s</source>
   <translation>Schlüssel {0}, {1} s</translation>
  </message>
  <message>
   <source>Ticked keys stay where and when they are</source>
   <translation>Angehakte Schlüssel bleiben, wo und wann sie sind</translation>
  </message>
  <message>
   <source>Locked</source>
   <translation>Gesperrt</translation>
  </message>
  <message>
   <source>The path may be longer then; without this it is as short as the clearance lets it</source>
   <translation>Der Weg kann dann länger sein; sonst ist er so kurz, wie der Abstand es zulässt</translation>
  </message>
  <message>
   <source>As much clearance as can be had</source>
   <translation>So viel Abstand wie möglich</translation>
  </message>
  <message>
   <source>The last change of the keys</source>
   <translation>Die letzte Änderung der Schlüssel</translation>
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
   <source>Adds the placement that the part has now (Ctrl+Return)</source>
   <translation>Fügt die jetzige Lage des Teils an (Strg+Eingabe)</translation>
  </message>
  <message>
   <source>&amp;Update</source>
   <translation>Über&amp;nehmen</translation>
  </message>
  <message>
   <source>Takes the part's placement of now for this key</source>
   <translation>Nimmt für diesen Schlüssel die jetzige Platzierung des Teils</translation>
  </message>
  <message>
   <source>&amp;Insert</source>
   <translation>E&amp;infügen</translation>
  </message>
  <message>
   <source>A new key half-way to the next one (Insert)</source>
   <translation>Neue Stützstelle auf halbem Weg zur nächsten (Einfg)</translation>
  </message>
  <message>
   <source>&amp;Duplicate</source>
   <translation>&amp;Verdoppeln</translation>
  </message>
  <message>
   <source>The same placement again (Ctrl+D)</source>
   <translation>Dieselbe Lage noch einmal (Strg+D)</translation>
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
   <source>The way back</source>
   <translation>Der Rückweg</translation>
  </message>
  <message>
   <source>Up</source>
   <translation>Nach oben</translation>
  </message>
  <message>
   <source>Earlier (Ctrl+Up)</source>
   <translation>Früher (Strg+Auf)</translation>
  </message>
  <message>
   <source>Down</source>
   <translation>Nach unten</translation>
  </message>
  <message>
   <source>Later (Ctrl+Down)</source>
   <translation>Später (Strg+Ab)</translation>
  </message>
  <message>
   <source>Eve&amp;n times</source>
   <translation>&amp;Gleiche Zeiten</translation>
  </message>
  <message>
   <source>One second from key to key</source>
   <translation>Eine Sekunde von Schlüssel zu Schlüssel</translation>
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
   <source>The key goes no farther than the part comes without touching a neighbour; neighbours are all visible parts</source>
   <translation>Der Schlüssel geht nur so weit, wie das Teil kommt, ohne einen Nachbarn zu berühren; Nachbarn sind alle sichtbaren Teile</translation>
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
   <source>The envelope is not up to date: this tells of the parts and the motion that it was computed from. Recompute it to see them move.</source>
   <translation>Die Hülle ist nicht aktuell: Dies gilt für die Teile und die Bewegung, aus denen sie berechnet wurde. Berechnen Sie sie neu, um die Bewegung zu sehen.</translation>
  </message>
  <message>
   <source>What made this?</source>
   <translation>Was hat das erzeugt?</translation>
  </message>
  <message>
   <source>Compute and remember</source>
   <translation>Berechnen und merken</translation>
  </message>
  <message>
   <source>Colour by</source>
   <translation>Färben nach</translation>
  </message>
  <message>
   <source>The place that was clicked</source>
   <translation>Die angeklickte Stelle</translation>
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
   <source>It is not remembered what made this envelope: it was computed without, or the document was closed since.</source>
   <translation>Was diese Hülle erzeugt hat, ist nicht gemerkt: Sie wurde ohne das berechnet, oder das Dokument war seither geschlossen.</translation>
  </message>
  <message>
   <source>It is not known what made this place.</source>
   <translation>Was diese Stelle erzeugt hat, ist nicht bekannt.</translation>
  </message>
  <message>
   <source>Mechanism</source>
   <translation>Mechanismus</translation>
  </message>
  <message>
   <source>0: a tenth of the size of the parts, and at least what the rules need</source>
   <translation>0: ein Zehntel der Größe der Teile, mindestens aber, was die Regeln brauchen</translation>
  </message>
  <message>
   <source>{0} parts that stand: {1}</source>
   <translation>{0} stehende Teile: {1}</translation>
  </message>
  <message>
   <source>Other visible parts, which stand still</source>
   <translation>Andere sichtbare Teile, die stillstehen</translation>
  </message>
  <message>
   <source>Parts that touch when the common time begins, as at their joints, may touch at any time</source>
   <translation>Teile, die sich zu Beginn der gemeinsamen Zeit berühren, etwa an ihren Gelenken, dürfen sich jederzeit berühren</translation>
  </message>
  <message>
   <source>Pair</source>
   <translation>Paar</translation>
  </message>
  <message>
   <source>List pairs nearer than</source>
   <translation>Paare auflisten näher als</translation>
  </message>
  <message>
   <source>none: select it, then press Pick</source>
   <translation>keines: Wählen Sie es aus, dann „Wählen“</translation>
  </message>
  <message>
   <source>Steps in which the arrows and arcs move; 0: freely</source>
   <translation>Schritte, in denen sich Pfeile und Bögen bewegen; 0: frei</translation>
  </message>
  <message>
   <source>Path</source>
   <translation>Bahn</translation>
  </message>
  <message>
   <source>A motion has at least two keys: move the part, then Capture.</source>
   <translation>Eine Bewegung hat mindestens zwei Stützstellen: Bewegen Sie das Teil, dann Aufnehmen.</translation>
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
   <source>Rounds the chosen key to these steps</source>
   <translation>Rundet die gewählte Stützstelle auf diese Schritte</translation>
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
   <source>Takes the marked parts out of the list</source>
   <translation>Nimmt die markierten Teile aus der Liste</translation>
  </message>
  <message>
   <source>Take a&amp;ll its parts</source>
   <translation>A&amp;lle seine Teile nehmen</translation>
  </message>
  <message>
   <source>Runs it once and takes every part that moves: motions that the document has of it are read again, others are made</source>
   <translation>Lässt es einmal laufen und nimmt jedes Teil, das sich bewegt: Bewegungen davon, die es im Dokument schon gibt, werden neu gelesen, andere gemacht</translation>
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
   <source>Pairs checked: {0}, no space is shared, smallest distance: {1}</source>
   <translation>Geprüfte Paare: {0}, kein gemeinsamer Raum, kleinster Abstand: {1}</translation>
  </message>
  <message>
   <source>Ta&amp;ke selected</source>
   <translation>Ausge&amp;wählte nehmen</translation>
  </message>
  <message>
   <source>Makes an object of what the two share, which tells when they change</source>
   <translation>Macht ein Objekt aus dem, was beide gemeinsam haben; es meldet, wenn sie sich ändern</translation>
  </message>
  <message>
   <source>Pairs checked: {0}, shared: {1}</source>
   <translation>Geprüfte Paare: {0}, gemeinsam: {1}</translation>
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
   <source>Seen from a moving part</source>
   <translation>Von einem bewegten Teil aus gesehen</translation>
  </message>
  <message>
   <source>The envelope is what the moving parts take up for this part</source>
   <translation>Die Hülle ist der Raum, den die bewegten Teile für dieses Teil einnehmen</translation>
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
   <source>Its motion</source>
   <translation>Seine Bewegung</translation>
  </message>
  <message>
   <source>Paths</source>
   <translation>Wege</translation>
  </message>
  <message>
   <source>Keys</source>
   <translation>Schlüssel</translation>
  </message>
  <message>
   <source>turns</source>
   <translation>Drehung</translation>
  </message>
  <message>
   <source>clearance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>The point that goes straight between two keys, and about which a key is turned; x, y, z of the keys are its own.</source>
   <translation>Der Punkt, der zwischen zwei Schlüsseln geradeaus geht und um den ein Schlüssel gedreht wird; x, y, z der Schlüssel sind die seinen.</translation>
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
   <source>Where it stands now</source>
   <translation>Dorthin, wo es jetzt steht</translation>
  </message>
  <message>
   <source>A placement</source>
   <translation>Eine Platzierung</translation>
  </message>
  <message>
   <source>Just out: by a distance</source>
   <translation>Nur hinaus: um eine Strecke</translation>
  </message>
  <message>
   <source>Just out: in a direction</source>
   <translation>Nur hinaus: in eine Richtung</translation>
  </message>
  <message>
   <source>Take</source>
   <translation>Nehmen</translation>
  </message>
  <message>
   <source>x, y, z of the direction in which the part leaves. Take: normal of the selected face, or direction of the selected edge</source>
   <translation>x, y, z der Richtung, in der das Teil hinausgeht. Nehmen: Normale der gewählten Fläche oder Richtung der gewählten Kante</translation>
  </message>
  <message>
   <source>x, y, z ({0}), yaw, pitch, roll (degrees) of the part in the document. Take: where the selected object stands, or else the part itself</source>
   <translation>x, y, z ({0}), Gier-, Nick-, Rollwinkel (Grad) des Teils im Dokument. Nehmen: wo das gewählte Objekt steht, sonst das Teil selbst</translation>
  </message>
  <message>
   <source>Hides what lies before the place; it follows rows and the player</source>
   <translation>Blendet aus, was vor der Stelle liegt; folgt den Zeilen und dem Abspielen</translation>
  </message>
  <message>
   <source>Makes a body of what the two parts of the row share at its time</source>
   <translation>Macht einen Körper aus dem, was beide Teile der Zeile zu deren Zeit gemeinsam haben</translation>
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
   <source>To the key before</source>
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
   <source>Seconds of the motion in one second</source>
   <translation>Sekunden der Bewegung in einer Sekunde</translation>
  </message>
  <message>
   <source>Loop</source>
   <translation>Schleife</translation>
  </message>
  <message>
   <source>Begins again at the end</source>
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
   <source>Distance</source>
   <translation>Abstand</translation>
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
   <source>The distance that this one asks for; empty: the common one below. Where contact is allowed: how deep the parts may overlap; empty: not measurably</source>
   <translation>Der Abstand, den dieser verlangt; leer: der gemeinsame unten. Wo Kontakt erlaubt ist: wie tief die Teile einander durchdringen dürfen; leer: nicht messbar</translation>
  </message>
  <message>
   <source>What this one asks for; empty: the common clearance below</source>
   <translation>Was dieser verlangt; leer: der gemeinsame Abstand unten</translation>
  </message>
  <message>
   <source>Rules</source>
   <translation>Regeln</translation>
  </message>
  <message>
   <source>Parts that touch, or are nearer than the clearance, where the way begins or ends may do so until no point of the part is farther than this from there</source>
   <translation>Teile, die sich am Anfang oder Ende des Wegs berühren oder näher sind als der Abstand, dürfen das, bis ein Punkt des Teils weiter als dies von dort weg ist</translation>
  </message>
  <message>
   <source>Contact allowed for</source>
   <translation>Kontakt erlaubt bis</translation>
  </message>
  <message>
   <source>Another number may find another path</source>
   <translation>Eine andere Zahl findet vielleicht einen anderen Weg</translation>
  </message>
  <message>
   <source>Time at most</source>
   <translation>Höchstens</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>Startzahl</translation>
  </message>
  <message>
   <source>&amp;Find paths in this order</source>
   <translation>Wege in dieser Reihenfolge &amp;finden</translation>
  </message>
  <message>
   <source>Sequence</source>
   <translation>Einbaufolge</translation>
  </message>
  <message>
   <source>is searched for ({0} of {1} found)</source>
   <translation>wird gesucht ({0} von {1} gefunden)</translation>
  </message>
  <message>
   <source>Find an &amp;order</source>
   <translation>&amp;Reihenfolge finden</translation>
  </message>
  <message>
   <source>By taking apart: what can be taken out goes, and the order is turned</source>
   <translation>Durch Zerlegen: was herausgenommen werden kann, geht, und die Reihenfolge wird umgekehrt</translation>
  </message>
  <message>
   <source>A part is out when it is so far from where it belongs</source>
   <translation>Ein Teil ist draußen, wenn es so weit von seinem Platz entfernt ist</translation>
  </message>
  <message>
   <source>The parts never turn</source>
   <translation>Die Teile drehen sich nie</translation>
  </message>
  <message>
   <source>Parts come from</source>
   <translation>Teile kommen von</translation>
  </message>
  <message>
   <source>Parts, the first one comes first</source>
   <translation>Teile, das erste kommt zuerst</translation>
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
   <source>Takes the marked part out of the sequence</source>
   <translation>Nimmt das markierte Teil aus der Einbaufolge</translation>
  </message>
  <message>
   <source>&amp;Up</source>
   <translation>&amp;Auf</translation>
  </message>
  <message>
   <source>The marked part comes one step earlier</source>
   <translation>Das markierte Teil kommt einen Schritt früher</translation>
  </message>
  <message>
   <source>D&amp;own</source>
   <translation>A&amp;b</translation>
  </message>
  <message>
   <source>The marked part comes one step later</source>
   <translation>Das markierte Teil kommt einen Schritt später</translation>
  </message>
  <message>
   <source>find</source>
   <translation>finden</translation>
  </message>
  <message>
   <source>Solid</source>
   <translation>Festkörper</translation>
  </message>
  <message>
   <source>Flat regions become single faces</source>
   <translation>Ebene Bereiche werden einzelne Flächen</translation>
  </message>
  <message>
   <source>How far the solid may leave the mesh; 0: exact, if the budget allows</source>
   <translation>Wie weit der Festkörper vom Netz abweichen darf; 0: genau, wenn die Grenzen es erlauben</translation>
  </message>
  <message>
   <source>Without a tolerance the smallest one is taken that does</source>
   <translation>Ohne Toleranz wird die kleinste genommen, die das erreicht</translation>
  </message>
  <message>
   <source>no limit</source>
   <translation>beliebig</translation>
  </message>
  <message>
   <source>Triangles as they are (AP242)</source>
   <translation>Dreiecke, wie sie sind (AP242)</translation>
  </message>
  <message>
   <source>A tessellated solid instead of faces: exact, quick, of any size, for programs that read tessellated STEP; FreeCAD 0.20 reads nothing from it</source>
   <translation>Ein tessellierter Körper statt Flächen: genau, schnell, beliebig groß, für Programme, die tessellierte STEP-Dateien lesen; FreeCAD 0.20 liest nichts daraus</translation>
  </message>
  <message>
   <source>Faces at most</source>
   <translation>Flächen höchstens</translation>
  </message>
  <message>
   <source>The solid is being tried out ...</source>
   <translation>Der Körper wird zur Probe gebaut ...</translation>
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
   <source>File at most</source>
   <translation>Datei höchstens</translation>
  </message>
  <message>
   <source>The limits ask for a tolerance of {0}</source>
   <translation>Die Grenzen verlangen eine Toleranz von {0}</translation>
  </message>
  <message>
   <source>Motion from path object</source>
   <translation>Bewegung aus Bahnobjekt</translation>
  </message>
  <message>
   <source>Motion from driven value</source>
   <translation>Bewegung aus gesteuertem Wert</translation>
  </message>
  <message>
   <source>Every part that moves gets a motion: no part is chosen.</source>
   <translation>Jedes Teil, das sich bewegt, erhält eine Bewegung: Es ist kein Teil gewählt.</translation>
  </message>
  <message>
   <source>How far the straight way between two poses may leave the path; corners are always poses</source>
   <translation>Wie weit der gerade Weg zwischen zwei Posen die Bahn verlassen darf; Ecken sind immer Posen</translation>
  </message>
  <message>
   <source>Fixed</source>
   <translation>Fest</translation>
  </message>
  <message>
   <source>Along the path</source>
   <translation>Entlang des Weges</translation>
  </message>
  <message>
   <source>Towards the second curve</source>
   <translation>Zur zweiten Kurve hin</translation>
  </message>
  <message>
   <source>Fixed: the part never turns. Along the path: x of the part stays on the tangent, with the least turn. Towards the second curve: z points to it; select both curves, the path first</source>
   <translation>Fest: das Teil dreht sich nie. Entlang des Weges: x des Teils bleibt auf der Tangente, mit der kleinsten Drehung. Zur zweiten Kurve hin: z zeigt zu ihr; beide Kurven wählen, den Weg zuerst</translation>
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
   <source>Time a pose</source>
   <translation>Zeit je Lage</translation>
  </message>
  <message>
   <source>the tool head</source>
   <translation>den Werkzeugkopf</translation>
  </message>
  <message>
   <source>the table</source>
   <translation>den Tisch</translation>
  </message>
  <message>
   <source>Degrees about the fixed axes x, then y, then z. The tool head: X Y Z are in the workpiece. The table: it turns the workpiece with its coordinates, X Y Z are in the machine</source>
   <translation>Grad um die festen Achsen x, dann y, dann z. Den Werkzeugkopf: X Y Z gelten im Werkstück. Den Tisch: er dreht das Werkstück samt seinen Koordinaten, X Y Z gelten in der Maschine</translation>
  </message>
  <message>
   <source>A B C turn</source>
   <translation>A B C drehen</translation>
  </message>
  <message>
   <source>Speed of G0</source>
   <translation>Tempo von G0</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Wert</translation>
  </message>
  <message>
   <source>Poses</source>
   <translation>Lagen</translation>
  </message>
  <message>
   <source>OK once more takes the motion as it is.</source>
   <translation>Noch einmal OK nimmt die Bewegung, wie sie ist.</translation>
  </message>
  <message>
   <source>From</source>
   <translation>Von</translation>
  </message>
  <message>
   <source>To</source>
   <translation>Bis</translation>
  </message>
  <message>
   <source>The poses of "{0}" come from {1} and follow it. To change a key, the link has to be cut: the motion then keeps the poses as they are. Cut it?</source>
   <translation>Die Lagen von „{0}“ kommen von {1} und folgen ihm. Um einen Schlüssel zu ändern, muss die Verknüpfung getrennt werden: Die Bewegung behält dann die Lagen, wie sie sind. Trennen?</translation>
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
   <source>The page of all runs, in the web browser</source>
   <translation>Die Seite aller Läufe, im Webbrowser</translation>
  </message>
  <message>
   <source>Go on</source>
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
   <source>Automatic: from the neighbouring keys. Stop: the part rests for a moment. Corner: straight on both sides. Given: as typed below</source>
   <translation>Selbsttätig: aus den Nachbarn. Halt: das Teil ruht einen Augenblick. Ecke: beiderseits gerade. Gegeben: wie unten eingetippt</translation>
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
  <message>
   <source>Time</source>
   <translation>Zeit</translation>
  </message>
 </context>
 <context>
  <name>SweptVolume_Properties</name>
  <message>
   <source>Envelope whose parts and motion are checked, and which is coloured</source>
   <translation>Hülle, deren Teile und Bewegung geprüft werden und die eingefärbt wird</translation>
  </message>
  <message>
   <source>Parts that move together, where no envelope is given</source>
   <translation>Gemeinsam bewegte Teile, wenn keine Hülle angegeben ist</translation>
  </message>
  <message>
   <source>Motion, where no envelope is given</source>
   <translation>Bewegung, wenn keine Hülle angegeben ist</translation>
  </message>
  <message>
   <source>Parts that stand still, seen through groups and links</source>
   <translation>Stillstehende Teile, durch Gruppen und Verknüpfungen gesehen</translation>
  </message>
  <message>
   <source>Check all other visible parts instead of Neighbours</source>
   <translation>Statt der Nachbarn alle anderen sichtbaren Teile prüfen</translation>
  </message>
  <message>
   <source>Distance asked for</source>
   <translation>Geforderter Abstand</translation>
  </message>
  <message>
   <source>How far the smallest distance may be off between two poses</source>
   <translation>Wie weit der kleinste Abstand zwischen zwei Lagen abweichen darf</translation>
  </message>
  <message>
   <source>Chord error to which solids are meshed; it is subtracted from the distances</source>
   <translation>Sehnenfehler, mit dem Festkörper vernetzt werden; er wird von den Abständen abgezogen</translation>
  </message>
  <message>
   <source>Neighbours, or groups of them, that have a rule of their own</source>
   <translation>Nachbarn, oder Gruppen von ihnen, mit eigener Regel</translation>
  </message>
  <message>
   <source>The rule of each of RuleParts: Required (a distance of its own), Contact (may be touched at any time), Ignore</source>
   <translation>Die Regel von jedem der RuleParts: Required (ein eigener Abstand), Contact (darf jederzeit berührt werden), Ignore (übergehen)</translation>
  </message>
  <message>
   <source>mm for each of RuleParts: the distance that it asks for, or how deep a contact may be</source>
   <translation>mm für jeden der RuleParts: der Abstand, den er verlangt, oder wie tief ein Kontakt sein darf</translation>
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
   <source>Worst verdict against the rules: clear, below, contact or clash</source>
   <translation>Schlechtestes Urteil gegen die Regeln: clear, below, contact oder clash</translation>
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
   <source>Inputs of the last run that gave nothing</source>
   <translation>Eingaben des letzten Laufs ohne Ergebnis</translation>
  </message>
  <message>
   <source>Inputs that were deleted (JSON)</source>
   <translation>Eingaben, die gelöscht wurden (JSON)</translation>
  </message>
  <message>
   <source>What AllVisible looks at, so that a change of it is noticed</source>
   <translation>Was AllVisible betrachtet, damit eine Änderung daran bemerkt wird</translation>
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
   <source>Solids and meshes that move together, seen through groups and links</source>
   <translation>Gemeinsam bewegte Festkörper und Netze, durch Gruppen und Verknüpfungen gesehen</translation>
  </message>
  <message>
   <source>Motion of the parts</source>
   <translation>Bewegung der Teile</translation>
  </message>
  <message>
   <source>One motion for each of Generators, where they move by themselves; empty: all by Motion</source>
   <translation>Je eine Bewegung für Generators, wenn sie sich einzeln bewegen; leer: alle nach Motion</translation>
  </message>
  <message>
   <source>Part that moves itself; the envelope is what it sees</source>
   <translation>Teil, das sich selbst bewegt; die Hülle ist, was es sieht</translation>
  </message>
  <message>
   <source>Motion of the reference part</source>
   <translation>Bewegung des Bezugsteils</translation>
  </message>
  <message>
   <source>Cells along the longest side of the sweep; used while CellSize is 0</source>
   <translation>Zellen entlang der längsten Seite; gilt, solange CellSize 0 ist</translation>
  </message>
  <message>
   <source>Edge of a cell of the sampling grid; 0: from Resolution</source>
   <translation>Kante einer Zelle des Abtastgitters; 0: aus Resolution</translation>
  </message>
  <message>
   <source>How far the triangles of a solid may leave it, in cells</source>
   <translation>Wie weit die Dreiecke eines Festkörpers von ihm abweichen dürfen, in Zellen</translation>
  </message>
  <message>
   <source>Simplification: largest deviation allowed; 0: none</source>
   <translation>Vereinfachung: größte erlaubte Abweichung; 0: keine</translation>
  </message>
  <message>
   <source>Safety distance by which the envelope is grown</source>
   <translation>Sicherheitsabstand, um den die Hülle wächst</translation>
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
   <source>Poses are left out while no point of the part has moved farther than this from the last one kept; 0: none</source>
   <translation>Lagen werden ausgelassen, solange sich kein Punkt des Teils weiter als dies von der letzten behaltenen entfernt hat; 0: keine</translation>
  </message>
  <message>
   <source>How surface pieces inside one cell are told apart</source>
   <translation>Wie Flächenstücke in einer Zelle unterschieden werden</translation>
  </message>
  <message>
   <source>Where the sampling runs</source>
   <translation>Wo die Abtastung läuft</translation>
  </message>
  <message>
   <source>Whether it is remembered which face or edge made each triangle: Off; Session: until the document is closed; Document: stored with it, which makes it larger</source>
   <translation>Ob gemerkt wird, welche Fläche oder Kante jedes Dreieck erzeugt hat: Off: nein; Session: bis das Dokument geschlossen wird; Document: darin gespeichert, wodurch es größer wird</translation>
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
   <source>Parts that move, each with the motion of the same number</source>
   <translation>Teile, die sich bewegen, jedes mit der Bewegung derselben Nummer</translation>
  </message>
  <message>
   <source>The motion of each of the moving parts, over common time</source>
   <translation>Die Bewegung jedes der bewegten Teile, über gemeinsame Zeit</translation>
  </message>
  <message>
   <source>Check the other visible parts as well, which stand still, instead of Neighbours</source>
   <translation>Auch die anderen sichtbaren Teile prüfen, die stillstehen, statt Neighbours</translation>
  </message>
  <message>
   <source>Pairs that come nearer than this are listed; 0: a tenth of the size of the parts</source>
   <translation>Paare, die sich näher kommen, werden aufgelistet; 0: ein Zehntel der Größe der Teile</translation>
  </message>
  <message>
   <source>Pairs of parts, or of groups, that have a rule of their own: first, second, first ...</source>
   <translation>Paare von Teilen oder Gruppen mit eigener Regel: erstes, zweites, erstes ...</translation>
  </message>
  <message>
   <source>mm for each pair of RuleParts: the distance that it asks for, or how deep a contact may be</source>
   <translation>mm für jedes Paar von RuleParts: der verlangte Abstand, oder wie tief eine Berührung sein darf</translation>
  </message>
  <message>
   <source>Pairs of parts that were checked, far ones as well</source>
   <translation>Geprüfte Paare von Teilen, auch weit entfernte</translation>
  </message>
  <message>
   <source>Time of each pose (s), growing</source>
   <translation>Zeit jeder Lage (s), wachsend</translation>
  </message>
  <message>
   <source>Pose of the moving part at each time</source>
   <translation>Lage des bewegten Teils zu jeder Zeit</translation>
  </message>
  <message>
   <source>What the part does between two poses. Linear: straight line and even turn. Screw: one screw movement. Spline: smooth through all poses. None: it only stands at them</source>
   <translation>Was das Teil zwischen zwei Posen tut. Linear: gerade Linie und gleichmäßige Drehung. Screw: eine Schraubbewegung. Spline: glatt durch alle Posen. None: es steht nur an ihnen</translation>
  </message>
  <message>
   <source>Point that goes straight (Linear) or along the spline between two poses, in the coordinates that a pose places: of the part where Frame is Absolute</source>
   <translation>Punkt, der zwischen zwei Lagen geradeaus geht (Linear) oder auf dem Spline, in den Koordinaten, die eine Lage setzt: denen des Teils, wenn Frame Absolute ist</translation>
  </message>
  <message>
   <source>Parts that this motion moves; the path editor shows the first of them</source>
   <translation>Teile, die diese Bewegung bewegt; der Bahneditor zeigt das erste</translation>
  </message>
  <message>
   <source>What else the source of this motion moved when it was read</source>
   <translation>Was die Quelle dieser Bewegung beim Lesen sonst noch bewegte</translation>
  </message>
  <message>
   <source>Spline: what happens at each pose: Auto, Stop, Corner or Given (then by Velocities); missing ones are Auto</source>
   <translation>Spline: was an jeder Pose geschieht: Auto, Stop, Corner oder Given (dann nach Velocities); fehlende sind Auto</translation>
  </message>
  <message>
   <source>Spline: velocity at each pose with the tangent Given (mm/s)</source>
   <translation>Spline: Geschwindigkeit an jeder Pose mit der Tangente Given (mm/s)</translation>
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
   <source>Whether the motion can be used</source>
   <translation>Ob die Bewegung brauchbar ist</translation>
  </message>
  <message>
   <source>What is to be known of the poses as they were read</source>
   <translation>Was über die gelesenen Lagen zu wissen ist</translation>
  </message>
  <message>
   <source>State of the source when it was read</source>
   <translation>Zustand der Quelle, als sie gelesen wurde</translation>
  </message>
  <message>
   <source>Number of poses; along a path 0: as many as SourceAccuracy asks for</source>
   <translation>Zahl der Lagen; entlang eines Pfads 0: so viele, wie SourceAccuracy verlangt</translation>
  </message>
  <message>
   <source>How far the straight way between two poses may leave the path</source>
   <translation>Wie weit der gerade Weg zwischen zwei Lagen den Pfad verlassen darf</translation>
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
   <source>Speed of G0</source>
   <translation>Geschwindigkeit von G0</translation>
  </message>
  <message>
   <source>What the words A, B and C turn: the tool head, or the table</source>
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
   <source>Parts in the order in which they are installed</source>
   <translation>Teile in der Reihenfolge, in der sie eingebaut werden</translation>
  </message>
  <message>
   <source>The motion of each of the parts, which ends where the part belongs</source>
   <translation>Die Bewegung jedes Teils, die dort endet, wohin das Teil gehört</translation>
  </message>
  <message>
   <source>Clearance from all that is there when a part comes</source>
   <translation>Abstand zu allem, was da ist, wenn ein Teil kommt</translation>
  </message>
  <message>
   <source>So far from its ends a part may touch what it touches there</source>
   <translation>So weit von seinen Enden darf ein Teil berühren, was es dort berührt</translation>
  </message>
  <message>
   <source>Parts that have a path</source>
   <translation>Teile, die einen Weg haben</translation>
  </message>
  <message>
   <source>Parts, envelopes or other reserved spaces: the one side</source>
   <translation>Teile, Hüllen oder andere reservierte Räume: die eine Seite</translation>
  </message>
  <message>
   <source>Parts, envelopes or other reserved spaces: the other side</source>
   <translation>Teile, Hüllen oder andere reservierte Räume: die andere Seite</translation>
  </message>
  <message>
   <source>Motion that puts the one side where it is at Time; none: it stands</source>
   <translation>Bewegung, die die eine Seite dorthin bringt, wo sie zur Zeit Time ist; keine: sie steht</translation>
  </message>
  <message>
   <source>Motion that puts the other side where it is at Time; none: it stands</source>
   <translation>Bewegung, die die andere Seite dorthin bringt, wo sie zur Zeit Time ist; keine: sie steht</translation>
  </message>
  <message>
   <source>Time of the motions (s)</source>
   <translation>Zeit der Bewegungen (s)</translation>
  </message>
  <message>
   <source>How far the triangles of solids may leave them</source>
   <translation>Wie weit die Dreiecke von Festkörpern von diesen abweichen dürfen</translation>
  </message>
  <message>
   <source>Whether the result is current</source>
   <translation>Ob das Ergebnis aktuell ist</translation>
  </message>
  <message>
   <source>What is to be said of the result</source>
   <translation>Was zum Ergebnis zu sagen ist</translation>
  </message>
  <message>
   <source>Volume that both share</source>
   <translation>Volumen, das beide gemeinsam haben</translation>
  </message>
  <message>
   <source>Smallest distance where they share nothing</source>
   <translation>Kleinster Abstand, wo sie nichts gemeinsam haben</translation>
  </message>
  <message>
   <source>How deep a point of one lies inside the other</source>
   <translation>Wie tief ein Punkt des einen im anderen liegt</translation>
  </message>
  <message>
   <source>Envelope (or any closed mesh) of which this is the solid</source>
   <translation>Hülle (oder ein geschlossenes Netz), deren Festkörper dies ist</translation>
  </message>
  <message>
   <source>Flat regions become single faces</source>
   <translation>Ebene Bereiche werden einzelne Flächen</translation>
  </message>
  <message>
   <source>At most this many faces; without a Tolerance it is chosen so</source>
   <translation>Höchstens so viele Flächen; ohne Tolerance wird sie danach gewählt</translation>
  </message>
  <message>
   <source>The solid may leave the mesh by this: cylinders, spheres and the like are found, the rest is simplified. 0: exact, unless MaxFaces asks for more</source>
   <translation>So weit darf der Festkörper vom Netz abweichen: Zylinder, Kugeln und dergleichen werden erkannt, der Rest wird vereinfacht. 0: genau, sofern MaxFaces nicht mehr verlangt</translation>
  </message>
  <message>
   <source>Largest distance of the mesh from the solid, as measured</source>
   <translation>Größter gemessener Abstand des Netzes vom Festkörper</translation>
  </message>
  <message>
   <source>Largest tolerance of an edge of the solid: its faces meet within it</source>
   <translation>Größte Toleranz einer Kante des Festkörpers: so genau treffen sich seine Flächen</translation>
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
   <source>Study file (TOML) with the runs, where they are not those of Sources</source>
   <translation>Studiendatei (TOML) mit den Läufen, wo es nicht die von Sources sind</translation>
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
   <source>About so many triangles are drawn of a heavy mesh; 0: all</source>
   <translation>So viele Dreiecke etwa werden von einem schweren Netz gezeichnet; 0: alle</translation>
  </message>
  <message>
   <source>What the colours tell, where it is remembered what made it</source>
   <translation>Was die Farben sagen, wo gemerkt ist, was sie erzeugt hat</translation>
  </message>
  <message>
   <source>Length of the axes drawn at each pose (mm); 0: automatic</source>
   <translation>Länge der Achsen an jeder Lage (mm); 0: automatisch</translation>
  </message>
  <message>
   <source>Width of the path line (pixels)</source>
   <translation>Breite der Bahnlinie (Pixel)</translation>
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
