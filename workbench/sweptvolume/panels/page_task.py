# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes reports of checks in the background: HTML through the core, PDF through Qt."""
import re

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import core, page, quantities, targets
from ..runner import Task
from ..safe_file import written_beside
from ..texts import translate
from .page_pictures import SIZE, Pictures

try:
    from PySide import QtSvg
except ImportError:  # without this module, the PDF has no graph
    QtSvg = None

#: Widths of the graph and of pictures on A4 within the margins, in pixels of Qt's text documents.
WIDTH, PICTURE_WIDTH = 600, 460
_GRAPH = re.compile(r'<svg class="graph".*?</svg>', re.S)
#: Parts of the page that work only on a screen.
_SCREEN = re.compile(r'<span class="screen">.*?</span>', re.S)


def _graph_image(svg):
    drawing = QtSvg.QSvgRenderer(QtCore.QByteArray(svg.encode("utf-8")))
    image = QtGui.QImage(drawing.defaultSize() * 2, QtGui.QImage.Format_RGB32)
    image.fill(QtCore.Qt.white)
    painter = QtGui.QPainter(image)
    drawing.render(painter)
    painter.end()
    return image


def _for_qt(text, document):
    """Converts HTML to the subset of Qt's text documents. Graphs become pictures of the document.
    Pictures get both width and height, which Qt needs."""
    text = _SCREEN.sub("", text)
    sides = (PICTURE_WIDTH, PICTURE_WIDTH * SIZE[1] // SIZE[0])
    text = text.replace("<figure><img ", '<figure><img width="{}" height="{}" '.format(*sides))
    if QtSvg is not None:
        pictures = []

        def shown(found):
            image = _graph_image(found.group(0))
            pictures.append("graph{}.png".format(len(pictures)))
            url = QtCore.QUrl(pictures[-1])
            document.addResource(QtGui.QTextDocument.ImageResource, url, image)
            height = WIDTH * image.height() // image.width()
            place = '<img src="{}" width="{}" height="{}" />'
            return place.format(pictures[-1], WIDTH, height)

        text = _GRAPH.sub(shown, text)
    for unknown, known in (("figure", "div"), ("figcaption", "p")):
        text = text.replace("<" + unknown + ">", "<" + known + ">")
        text = text.replace("</" + unknown + ">", "</" + known + ">")
    return text


def pdf_of(text):
    """Returns the bytes of a PDF (A4) for a page from the template "print". Any thread."""
    document = QtGui.QTextDocument()
    document.setHtml(_for_qt(text, document))
    content = QtCore.QByteArray()
    target = QtCore.QBuffer(content)
    target.open(QtCore.QIODevice.WriteOnly)
    writer = QtGui.QPdfWriter(target)
    margins = QtCore.QMarginsF()  # the text document has its own margins
    size = QtGui.QPageSize(QtGui.QPageSize.A4)
    upright, unit = QtGui.QPageLayout.Portrait, QtGui.QPageLayout.Millimeter
    writer.setPageLayout(QtGui.QPageLayout(size, upright, margins, unit))
    writer.setCreator("Swept Volume")
    writer.setTitle(document.metaInformation(QtGui.QTextDocument.DocumentTitle))
    document.print_(writer)
    del writer  # writes the rest of the file
    target.close()
    return bytes(content.data())


class WritingTask(Task):
    """Writes the bytes from work() to the file `path`. The document does not change."""

    writes = False

    def finish(self, value):
        with written_beside(self.path) as beside, open(beside, "wb") as out:
            out.write(value)
        App.Console.PrintMessage(
            translate("SweptVolume", "Written: {0} ({1})\n").format(
                self.path, quantities.megabytes(len(value))
            )
        )


class PageTask(WritingTask):
    """Writes the report of a check."""

    def __init__(self, obj, path):
        self.title = translate("SweptVolume", "Export report")
        self.document = obj.Document
        self.watched = [obj]
        self.path = path
        page.check_target(path)
        targets.check_not_read(path)
        self.pdf = page.is_pdf(path)
        changed = bool(Gui.getDocument(obj.Document.Name).Modified)
        self.request = page.request(obj, changed, self.pdf)
        wanted = self.pdf or not core.has_page_view()
        self.pictures = Pictures(obj, self.request.report) if wanted else None

    def steps(self, control):
        return self.pictures.steps(control) if self.pictures is not None else iter(())

    def work(self, control):
        pictures = self.pictures.packed() if self.pictures is not None else []
        text = page.text(self.request, control, pictures, view=not self.pdf)
        return pdf_of(text) if self.pdf else text.encode("utf-8")
