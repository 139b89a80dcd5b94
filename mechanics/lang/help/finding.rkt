#lang racket/base
;; Findings of the search.  Prefab, so that a table of findings can be written into compiled code.

(provide (struct-out finding))

;; kind : 'name, 'page, 'section, 'library, 'program, or 'exercise, one that has a program
;; title, sentence : texts
;; where : the library of a name; a page, "chapter-1" or "chapter-1#tag of a section"; a program's
;; file under examples/mechanics
(struct finding (kind title where sentence) #:prefab)
