#lang racket/base
;; The card of a name: its entry in the manual, without typography.  Prefab, so that a table of
;; cards can be written into compiled code.

(provide (struct-out card) (struct-out signature) (struct-out argument) (struct-out example)
         takes?)

;; name : symbol; library : the module that exports it; page : its page of the manual
;; signatures : of one entry, or of all that the manual has for the name
;; sentence : text or #f; demonstration : example or #f
;; place : text, such as "1.5, p. 33", or #f; also : symbols of related cards
(struct card (name library page signatures sentence demonstration place also) #:prefab)

;; kind : 'procedure, 'form, 'value or 'parameter
;; call : texts between which a line may break: "(evolve" "f" "[#:step h])"
;; result : text or #f
;; needed, optional, keywords : arguments; rest : text such as "f ...", or #f
;; parameters : the number in each inner call, of ((f m k) local): (2)
(struct signature (kind call result needed optional keywords rest parameters) #:prefab)

;; name : text; what : text on its kind, "Lagrangian"; default : text or #f; keyword : symbol or #f
(struct argument (name what default keyword) #:prefab)

;; libraries : modules that the program requires; definitions : texts of the definitions that the
;; expressions use; expressions : texts; run : texts of the expressions evaluated in their place
(struct example (libraries definitions expressions run) #:prefab)

;; Does a signature take n arguments without keywords?
(define (takes? s n)
  (define least (length (signature-needed s)))
  (and (>= n least)
       (or (and (signature-rest s) #t)
           (<= n (+ least (length (signature-optional s)))))))
