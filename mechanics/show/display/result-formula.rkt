#lang racket/base
;; A result to be typeset: the tree of its formula, and the text that it is elsewhere.
;;
;; It is made without a library that draws.

(require "../typesetting/break.rkt"
         "../../algebra/notation/tree.rkt"
         racket/fasl)

(provide (struct-out formula) formula-tree formula-size
         formula->bytes bytes->formula formula-syntax)

;; body    : tree
;; remarks : trees of the assumptions of simplification, each with its label: (label . tree)
;; program : the S-expression of the value, or its text, in lines
;; text    : the same with the remarks, as it is printed where there are no pictures
;; width   : columns there are for a line
;; Prefab, as the tree is: so it can be written and read by other instances of this file.
(struct formula (body remarks program text width) #:prefab)

;; The whole, cut into lines.
(define (formula-tree f)
  (define body (fit (formula-body f) (formula-width f)))
  (define remarks (formula-remarks f))
  (if (null? remarks)
      body
      (broken (list body
                    (report (for/list ([r (in-list remarks)])
                              (report-line 0 (car r) (list (cdr r)))))))))

;; The number of numbers, names and words in a tree; a shared part counts as often as it is drawn.
(define (formula-size tree)
  (define known (make-hasheq))
  (let size ([t tree])
    (define parts (tree-parts t))
    (hash-ref! known t (lambda () (if (null? parts) 1 (apply + (map size parts)))))))

;; ---------------------------------------------------------------------------
;; In files

(define (formula->bytes f) (s-exp->fasl f))

;; -> formula, or #f of bytes that are none
(define (bytes->formula bytes)
  (define f (with-handlers ([exn:fail? (lambda (e) #f)]) (fasl->s-exp bytes)))
  (and (formula? f) (string? (formula-program f)) (string? (formula-text f)) f))

;; The syntax of a formula in a program: the one S-expression that its text is; if it is
;; words, these, in a string.
(define (formula-syntax f location)
  (define program (formula-program f))
  (define data (with-handlers ([exn:fail:read? (lambda (e) '())])
                 (for/list ([d (in-port read (open-input-string program))]) d)))
  (datum->syntax #f (if (and (pair? data) (null? (cdr data))) (car data) program) location))
