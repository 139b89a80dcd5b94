#lang racket/base
;; Declaring relations: they are read, simplified and added to a set.
;;
;; A set knows signs by the simplified form of expressions, which depends on the
;; set: with x > 0, |x| - 1 becomes x - 1.  So relations that simplify to something
;; else in the new set are added in that form too.

(require racket/list
         "domain-question.rkt" "simplify-expression.rkt"
         "../assumption/assumption-set.rkt" "../assumption/emptiness.rkt"
         "../assumption/narrowing.rkt"
         "../assumption/relation.rkt")

(provide declare-relations with-relations declared-relations without-relations
         (struct-out exn:algebra:contradiction))

;; data : relations between two expressions, as datums
;; rejection : datum -> a procedure to call if it is no relation (see assumption/relation.rkt)
;; Raises exn:algebra:contradiction.
(define (declare-relations A data [rejection (lambda (d) raise-no-relation)])
  (define new
    (for/list ([d (in-list data)])
      (simplified (read-relation d (rejection d)) no-assumptions)))
  (define extended (add A new))
  (define impossible (impossible-among (assumptions-relations extended) new))
  (when impossible (raise-contradiction impossible))
  (add extended
       (for*/list ([r (in-list (assumptions-relations extended))]
                   [s (in-value (simplified r extended))]
                   #:unless (equal? (relation-expression r) (relation-expression s)))
         s)))

(define (add A new)
  (if (null? new) A (add-relations A new (neutral-workspace))))

(define (simplified r A)
  (relation (relation-datum r)
            (simplify-expression (relation-expression r) (with-automatic-assumptions A #f))
            (relation-signs r)))

;; A with the relations of these datums; A itself where they contradict it.
(define (with-relations A data)
  (with-handlers ([exn:algebra:contradiction? (lambda (e) A)]) (declare-relations A data)))

;; The datums of the relations, each once, in the order of declaration.
(define (declared-relations A)
  (remove-duplicates (map relation-datum (assumptions-relations A))))

;; The set without those of these datums, and without their consequences.
(define (without-relations A data)
  (declare-relations (with-automatic-assumptions no-assumptions (assumptions-automatic? A))
                     (remove* data (declared-relations A))))
