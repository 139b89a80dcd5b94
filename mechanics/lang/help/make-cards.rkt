#lang racket/base
;; Cards of all names that have an entry in the manual, made while the table is compiled.

(require racket/list
         "card.rkt" "choose-example.rkt" "page.rkt" "prose.rkt")

(provide manual-cards)

;; pages of the manual's reference; context : syntax of the language of the examples
;; -> cards, one for each name, in the manual's order
(define (manual-cards pages context)
  (define all
    (for*/list ([p (in-list pages)] [e (in-list (page-entries p))]
                [name (in-list (remove-duplicates (map car (entry-names e))))])
      (make-card name e p pages context)))
  (define known (for/hasheq ([c (in-list all)]) (values (card-name c) #t)))
  (define joined (map join (group-by card-name all)))
  (for/list ([c (in-list joined)]
             [before (in-list (cons #f joined))] [after (in-list (cdr (append joined '(#f))))])
    (with-relations c (filter values (list after before)) known)))

(define (make-card name e p pages context)
  (define body (entry-body e))
  (card name (entry-library e) (page-title p)
        (for/list ([n (in-list (entry-names e))] #:when (eq? (car n) name)) (cdr n))
        (first-sentence body)
        (choose-example name e p pages context)
        (place-in-the-book body)
        (append (map car (entry-names e)) (names-mentioned body))))

;; Joins the cards of one name: the text of the first with the signatures and related names of all.
(define (join same)
  (define c (car same))
  (struct-copy card c
               [signatures (append-map card-signatures same)]
               [also (append-map card-also same)]))

;; Adds related names: those explained or mentioned together, then the neighbours on the page.
(define (with-relations c neighbours known)
  (define near
    (for/list ([other (in-list neighbours)] #:when (equal? (card-page other) (card-page c)))
      (card-name other)))
  (define-values (failures others) (partition failure? (append (card-also c) near)))
  (define names
    (for/list ([n (in-list (remove-duplicates (append others failures)))]
               #:when (and (hash-ref known n #f) (telling? n) (not (eq? n (card-name c)))))
      n))
  (struct-copy card c [also (take names (min most-related (length names)))]))

(define most-related 5)

(define (failure? name) (regexp-match? #rx"^exn:" (symbol->string name)))

;; Is the name a useful reference?  Arithmetic stands in every program.
(define (telling? name) (not (memq name '(+ - * / = expt square up down define lambda sqrt sin))))

;; The text of the first @sicm{...}, or #f.
(define (place-in-the-book body)
  (define found (findf (lambda (part) (and (pair? part) (eq? (car part) 'sicm))) body))
  (and found (plain-text (cdr found))))

;; Names in the code of a text, but not of its examples.
(define (names-mentioned parts)
  (for*/list ([part (in-list parts)]
              #:when (and (pair? part) (memq (car part) '(racket racketblock itemlist)))
              [name (in-list (flatten part))]
              #:when (symbol? name))
    name))
